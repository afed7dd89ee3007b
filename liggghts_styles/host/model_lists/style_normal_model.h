// Read by contact_models.h in place of the list that the LIGGGHTS package does not ship:
// the plugin compiles no normal model of LIGGGHTS; its own is host/normal_model_jkr.h.
