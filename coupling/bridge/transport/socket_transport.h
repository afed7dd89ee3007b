// SPDX-License-Identifier: GPL-3.0-or-later
/// \file socket_transport.h
/// Two programs that were started separately, joined by a Unix domain or a TCP socket.
///
/// One side listens, the other connects; which one does is free. They meet
///   - at an address both know: "unix:/run/pipe.socket" or "host:port", or
///   - through a file that the listener writes (beside, then renamed) and the other one waits for.
/// The listener serves one client. Later ones are told that the place is taken, as long as the
/// transport lives. A Unix socket belongs to the user alone (mode 0600). TCP stays on loopback unless
/// both sides give the same token; the token keeps strangers out of a run by mistake or scan, but
/// travels in clear text: use it within a network that you trust.
/// Nothing waits longer than the timeout, also for the look-up of a host or a client that never stops
/// sending; who has not given the token yet may send 64 KiB. A peer that dies is noticed at once (end of
/// file, reset).
/// Tests: tests/coupling/bridge/socket_test.cpp
#pragma once

#include <memory>
#include <string>

#include "coupling/bridge/transport/transport.h"

namespace powderlink::bridge {

struct SocketOptions {
  /// "unix:PATH" or "HOST:PORT", "[IPv6]:PORT". Listener: port 0 takes a free one; empty is
  /// "127.0.0.1:0". Connecting side: empty reads it from the rendezvous file.
  std::string address;
  /// File through which the sides meet; empty when both know the address.
  std::string rendezvous_file;
  /// Demanded on any address but Unix and loopback; checked wherever it is given.
  std::string token;
  /// For the other side to come [s].
  double timeout_s = 60.0;
};

/// Waits for one client. Throws bad_input (address, token missing), timeout (with the reasons why
/// clients were sent away), wrong_version.
std::unique_ptr<Transport> listen_on_socket(const SocketOptions& options);

/// Tries again until somebody listens. Throws bad_input, timeout (with the last reason), refused
/// (place taken, wrong token), wrong_version.
std::unique_ptr<Transport> connect_to_socket(const SocketOptions& options);

}  // namespace powderlink::bridge
