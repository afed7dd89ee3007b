// SPDX-License-Identifier: GPL-3.0-or-later
/// \file socket_address.h
/// Addresses as users write them, and the file through which two programs meet.
/// Tests: tests/coupling/bridge/socket_test.cpp
#pragma once

#include <string>

#include <boost/asio/generic/stream_protocol.hpp>

#include "coupling/bridge/transport/deadline.h"

namespace powderlink::bridge {

struct SocketAddress {
  bool is_unix = false;
  std::string path;  ///< Unix
  std::string host;  ///< TCP
  std::string port;

  /// Throws bad_input.
  static SocketAddress parse(const std::string& text);
  std::string text() const;
};

using Endpoint = boost::asio::generic::stream_protocol::endpoint;

struct ResolvedAddress {
  Endpoint endpoint;
  bool within_machine = false;  ///< Unix or loopback: no token needed
};

/// Looks the host up. Throws bad_input, timeout.
ResolvedAddress resolve(const SocketAddress& address, const Deadline& deadline);

/// Readers see the old file or the whole new one. Throws bad_input.
void write_rendezvous(const std::string& file, const SocketAddress& address);
/// False when there is no such file yet. Throws bad_input when it is not a rendezvous file.
bool read_rendezvous(const std::string& file, SocketAddress& address);

}  // namespace powderlink::bridge
