// SPDX-License-Identifier: GPL-3.0-or-later
/// \file transport_pairs.h
/// Both ends of a transport for two threads or processes of a test.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "coupling/bridge/transport/socket_transport.h"
#include "tests/coupling/bridge/memory_transport.h"

namespace powderlink::test {

using MakeTransport = std::function<std::unique_ptr<bridge::Transport>()>;

inline std::pair<MakeTransport, MakeTransport> socket_makers(const bridge::SocketOptions& listener,
                                                             const bridge::SocketOptions& client) {
  return {[=] { return bridge::listen_on_socket(listener); },
          [=] { return bridge::connect_to_socket(client); }};
}

/// \param kind  memory, unix or tcp; the latter two meet through a file in `folder`
inline std::pair<MakeTransport, MakeTransport> transport_makers(const std::string& kind,
                                                                const std::string& folder) {
  constexpr double timeout_s = 10.0;
  if (kind == "memory") {
    auto ends = bridge::memory_transport_pair();
    auto first = std::make_shared<std::unique_ptr<bridge::Transport>>(std::move(ends.first));
    auto second = std::make_shared<std::unique_ptr<bridge::Transport>>(std::move(ends.second));
    return {[=] { return std::move(*first); }, [=] { return std::move(*second); }};
  }
  bridge::SocketOptions listener{"", folder + "/meet", "", timeout_s};
  const bridge::SocketOptions client{"", folder + "/meet", "", timeout_s};
  if (kind == "unix") listener.address = "unix:" + folder + "/socket";
  return socket_makers(listener, client);
}

}  // namespace powderlink::test
