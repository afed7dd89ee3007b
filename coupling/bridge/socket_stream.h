// SPDX-License-Identifier: GPL-3.0-or-later
/// \file socket_stream.h
/// A connected socket that carries frames; inner part of socket_transport.cpp.
#pragma once

#include <deque>
#include <string>

#include <boost/asio/generic/stream_protocol.hpp>

#include "coupling/bridge/frame.h"
#include "coupling/bridge/transport.h"

namespace powderlink::bridge {

using Socket = boost::asio::generic::stream_protocol::socket;

/// Waits until the descriptor is ready for one of `events` (of poll()); false after the deadline.
bool wait_for(int descriptor, short events, const Deadline& deadline);

class SocketStream {
 public:
  SocketStream(Socket socket, std::string peer);

  void send(Bytes& frame, const Deadline& deadline);
  void receive(Bytes& frame, const Deadline& deadline);
  const std::string& peer() const { return peer_; }
  void close() noexcept;

 private:
  /// Reads what is there, at most until one more frame is whole. False: nothing there now.
  bool read_some();
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
