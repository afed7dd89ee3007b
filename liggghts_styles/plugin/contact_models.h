// SPDX-License-Identifier: GPL-3.0-or-later
/// \file contact_models.h
/// Makes normal model `jkr` known to LIGGGHTS; harmless when called twice.
#pragma once

namespace powderlink::plugin {
void register_contact_models();
}
