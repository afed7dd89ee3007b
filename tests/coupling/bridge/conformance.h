// SPDX-License-Identifier: GPL-3.0-or-later
/// \file conformance.h
/// What every transport must do. Each case has two sides, which run in two threads or two processes;
/// a side that finds something wrong throws.
#pragma once

#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "coupling/bridge/transport/transport.h"

namespace powderlink::test {

using Side = void (*)(std::unique_ptr<bridge::Transport>);

struct ConformanceCase {
  const char* name;
  Side first;
  Side second;
};

/// GoogleTest prints it into the name of a test.
inline void PrintTo(const ConformanceCase& test, std::ostream* out) { *out << test.name; }

const std::vector<ConformanceCase>& conformance_cases();

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

/// Throws unless `failure` (of failure_of()) is empty.
inline void require_none(const std::string& failure) { require(failure.empty(), failure); }

}  // namespace powderlink::test
