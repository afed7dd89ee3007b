// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/library_logs.h"

#include <glog/logging.h>

namespace powderlink::analysis {

void silence_library_logs() { FLAGS_minloglevel = google::GLOG_FATAL; }

}  // namespace powderlink::analysis
