// Normal models of LIGGGHTS that combine with tangential model `spring_slider_dashpot`; stands in for the list
// that the LIGGGHTS package does not ship. The plugin's own is liggghts_styles/contact/normal_model_jkr.h.
#include "normal_model_hertz.h"
