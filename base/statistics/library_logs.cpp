// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/statistics/library_logs.h"

#include <glog/logging.h>

namespace powderlink {

void silence_library_logs() { FLAGS_minloglevel = google::GLOG_FATAL; }

}  // namespace powderlink
