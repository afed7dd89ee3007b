// Rolling models that combine with `jkr`; stands in for the list that the LIGGGHTS package does not ship.
#include "rolling_model_cdt.h"
#include "rolling_model_epsd2.h"
