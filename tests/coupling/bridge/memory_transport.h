// SPDX-License-Identifier: GPL-3.0-or-later
/// \file memory_transport.h
/// A transport without a wire: two ends within one process, one thread each.
#pragma once

#include <memory>
#include <utility>

#include "coupling/bridge/transport/transport.h"

namespace powderlink::bridge {

std::pair<std::unique_ptr<Transport>, std::unique_ptr<Transport>> memory_transport_pair();

}  // namespace powderlink::bridge
