// SPDX-License-Identifier: GPL-3.0-or-later
/// \file transport.h
/// How bytes get from one program to the other; what they mean is the business of Session.
///
/// A transport joins exactly two processes and carries whole frames, in order, both ways. Both may
/// send at once, also large frames: a transport reads on while it waits to write.
/// Errors are BridgeError: timeout, peer_lost (the other end closed or died), bad_frame (a stream that
/// does not hold frames). After one of them only close(), close_after_error() and destruction are allowed.
/// Not thread-safe: one thread per transport.
/// Tests: tests/coupling/bridge/conformance_test.cpp
#pragma once

#include <string>

#include "coupling/bridge/frame/bytes.h"
#include "coupling/bridge/transport/deadline.h"

namespace powderlink::bridge {

class Transport {
 public:
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// Returns when `frame` may be reused. Its bytes stay as they are, except after a timeout: the
  /// transport may then have taken the buffer.
  virtual void send(Bytes& frame, const Deadline& deadline) = 0;
  /// Replaces the content of `frame` by the next frame; capacity is reused.
  virtual void receive(Bytes& frame, const Deadline& deadline) = 0;
  /// Who is at the other end, for messages: "unix:/run/x", "127.0.0.1:4242", "rank 1 of solver".
  virtual const std::string& peer() const = 0;
  /// The other end reads what was sent before, then gets peer_lost. May be called twice.
  virtual void close() noexcept = 0;
  /// close() after the last frame told why: returns when the other end has had the time to say so
  /// itself, within 1 s. Over MPI the end of this program is the end of both.
  virtual void close_after_error() noexcept { close(); }

 protected:
  Transport() = default;
};

/// The error of a transport whose other end is gone.
inline BridgeError lost(const std::string& peer, const std::string& how) {
  return {BridgeError::Kind::peer_lost, "connection to " + peer, how,
          "a peer that stays until both have said goodbye",
          "see the log of the other program for the reason of its end"};
}

}  // namespace powderlink::bridge
