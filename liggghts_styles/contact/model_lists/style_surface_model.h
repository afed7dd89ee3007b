// Surface models that combine with `jkr`; stands in for the list that the LIGGGHTS package does not ship.
#include "surface_model_default.h"
