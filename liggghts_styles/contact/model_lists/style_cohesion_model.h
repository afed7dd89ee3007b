// Read by contact_models.h in place of the list that the LIGGGHTS package does not ship:
// the plugin compiles no cohesion model of LIGGGHTS.
