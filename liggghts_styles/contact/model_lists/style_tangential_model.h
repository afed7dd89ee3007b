// Tangential models that combine with `jkr` or, the last one, with `hertz`; stands in for the list that the
// LIGGGHTS package does not ship.
#include "liggghts_styles/contact/tangential_model_spring_slider_dashpot.h"
#include "tangential_model_history.h"
#include "tangential_model_no_history.h"
