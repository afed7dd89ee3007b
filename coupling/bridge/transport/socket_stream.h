// SPDX-License-Identifier: GPL-3.0-or-later
/// \file socket_stream.h
/// A connected socket that carries frames; inner part of socket_transport.cpp.
/// Tests: tests/coupling/bridge/socket_test.cpp
#pragma once

#include <deque>
#include <string>

#include <boost/asio/generic/stream_protocol.hpp>

#include "coupling/bridge/frame/frame.h"
#include "coupling/bridge/transport/transport.h"

namespace powderlink::bridge {

using Socket = boost::asio::generic::stream_protocol::socket;

/// Waits until the descriptor is ready for one of `events` (of poll()); false after the deadline.
bool wait_for(int descriptor, short events, const Deadline& deadline);

class SocketStream {
 public:
  SocketStream(Socket socket, std::string peer);

  void send(Bytes& frame, const Deadline& deadline);
  void receive(Bytes& frame, const Deadline& deadline);
  /// Largest frame to come: small as long as the other end may be anybody.
  void set_limits(const FrameLimits& limits) { limits_ = limits; }
  const std::string& peer() const { return peer_; }
  void close() noexcept;

 private:
  /// Reads what is there, at most until one more frame is whole. False: nothing there now, or late.
  bool read_some(const Deadline& deadline);
  void finish_part();

  Socket socket_;
  std::string peer_;
  FrameLimits limits_;
  Bytes part_;            ///< the frame that is coming in
  std::size_t have_ = 0;  ///< bytes of it that are there
  bool header_done_ = false;
  std::deque<Bytes> ready_;  ///< whole frames that came in while this side was writing
  Bytes spare_;
};

}  // namespace powderlink::bridge
