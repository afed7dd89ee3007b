// SPDX-License-Identifier: GPL-3.0-or-later
/// \file session.h
/// Who talks to whom about what. Both programs open a Session on their end of a transport; the
/// constructor exchanges a hello and refuses a peer that does not fit, with the same text on both
/// sides. With several ranks only rank 0 has a session, see on_first_rank() in mpi_world.h.
/// Tests: tests/coupling/bridge/session_test.cpp
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "coupling/bridge/frame/frame.h"
#include "coupling/bridge/transport/transport.h"

namespace powderlink::bridge {

/// The clock of one side at the first exchange, and what it knows of the other's.
struct Clock {
  double time_s = 0.0;
  /// The state is that of a checkpoint of a coupled run: the other side must be at the same moment.
  bool continues = false;
  /// In that run: this clock minus the other one [s], constant as long as the run goes on.
  double ahead_s = 0.0;
};

struct Hello {
  std::string role;       ///< "dem", "solver"; the two must differ
  std::string case_name;  ///< must be the same on both sides
  int ranks = 1;
  /// Physical time between two exchanges [s]; 0 when this side takes what the other one says.
  double exchange_interval_s = 0.0;
  std::vector<FieldSpec> offers;  ///< fields this side can send
  std::vector<FieldSpec> needs;   ///< fields this side must get
  Clock clock = {};
};

std::string to_text(const Hello& hello);
/// Throws bad_frame when the text is not a hello.
Hello hello_from_text(std::string_view text);
/// Throws mismatch when the two cannot work together; the text does not depend on the order.
void check_fit(const Hello& one, const Hello& other);

class Session {
 public:
  /// Shakes hands. Throws timeout, peer_lost, wrong_version, bad_frame, or mismatch (on both sides).
  /// \param timeout_s  for the handshake and for every later wait
  Session(std::unique_ptr<Transport> transport, Hello mine, double timeout_s);
  /// Without finish() before, the other side is told that this one ended early.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const Hello& mine() const { return mine_; }
  const Hello& peer() const { return peer_; }
  double timeout_s() const { return timeout_s_; }

  /// Sends a frame that is encoded. O(bytes).
  void send_frame(Bytes& frame);
  /// The next fields; valid until the next call. O(bytes). Throws peer_failed with the message of the
  /// other side when that side reported an error, peer_lost when it has finished.
  const FrameView& receive_frame();

  /// Both sides call it after the last exchange: waits until the other one is done, too.
  void finish();
  /// Tells the other side why this one stops, and closes. Call it before leaving on an error. Returns
  /// when the other side has had the time to say so, within 1.5 s.
  void fail(const std::string& why) noexcept;

 private:
  [[noreturn]] void throw_peer_error(const FrameView& frame) const;
  const FrameView& receive_any(const Deadline& deadline);
  void send_checked(Bytes& frame);
  std::string peer_name() const;

  std::unique_ptr<Transport> transport_;
  Hello mine_;
  Hello peer_;
  double timeout_s_;
  bool open_ = true;
  bool peer_finished_ = false;
  bool peer_failed_ = false;
  Bytes outgoing_;
  Bytes incoming_;
  FrameView view_;
};

}  // namespace powderlink::bridge
