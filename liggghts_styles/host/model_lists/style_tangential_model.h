// Tangential models that combine with `jkr`; stands in for the list that the LIGGGHTS package does not ship.
#include "tangential_model_history.h"
#include "tangential_model_no_history.h"
