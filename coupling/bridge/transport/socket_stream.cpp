// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/socket_stream.h"

#include <poll.h>

#include <cerrno>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>

namespace powderlink::bridge {

namespace asio = boost::asio;

bool wait_for(int descriptor, short events, const Deadline& deadline) {
  pollfd entry{descriptor, events, 0};
  while (true) {
    const int ready = poll(&entry, 1, deadline.remaining_ms());
    if (ready > 0) return true;
    if (ready == 0 && deadline.expired()) return false;
    if (ready < 0 && errno != EINTR && errno != EAGAIN) return true;  // the next call tells why
  }
}

SocketStream::SocketStream(Socket socket, std::string peer)
    : socket_(std::move(socket)), peer_(std::move(peer)) {
  socket_.non_blocking(true);
  resize(part_, header_bytes);
}

void SocketStream::finish_part() {
  ready_.push_back(std::move(part_));
  part_ = std::move(spare_);
  spare_ = Bytes();
  resize(part_, header_bytes);
  have_ = 0;
  header_done_ = false;
}

bool SocketStream::read_some(const Deadline& deadline) {
  const std::size_t whole_before = ready_.size();
  while (ready_.size() == whole_before) {
    boost::system::error_code error;
    const std::size_t got =
        socket_.read_some(asio::buffer(part_.data() + have_, part_.size() - have_), error);
    if (error == asio::error::would_block || error == asio::error::try_again) return false;
    if (error == asio::error::interrupted) continue;
    if (error) {
      throw lost(peer_, have_ > 0 ? "ended within a frame (" + error.message() + ")"
                                  : "ended by the other side (" + error.message() + ")");
    }
    have_ += got;
    if (have_ < part_.size()) {
      if (deadline.expired()) return false;  // an end that never stops sending
      continue;
    }
    if (!header_done_) {
      header_done_ = true;
      const std::uint64_t bytes = frame_bytes(part_, limits_);
      if (bytes > have_) {
        resize(part_, static_cast<std::size_t>(bytes));
        continue;
      }
    }
    finish_part();
  }
  return true;
}

void SocketStream::send(Bytes& frame, const Deadline& deadline) {
  std::size_t sent = 0;
  while (sent < frame.size()) {
    boost::system::error_code error;
    const std::size_t count =
        socket_.write_some(asio::buffer(frame.data() + sent, frame.size() - sent), error);
    if (error == asio::error::would_block || error == asio::error::try_again) {
      // The other side may be writing, too: reading on is what lets it get to its own reading.
      constexpr std::size_t most_frames_ahead = 64;
      const bool reads = ready_.size() < most_frames_ahead;
      const short events = reads ? POLLIN | POLLOUT : POLLOUT;
      if (deadline.expired() || !wait_for(socket_.native_handle(), events, deadline)) {
        throw deadline.error("room to send to " + peer_);
      }
      if (reads) read_some(deadline);
      continue;
    }
    if (error == asio::error::interrupted) continue;
    if (error) throw lost(peer_, "cannot be written to (" + error.message() + ")");
    sent += count;
  }
}

void SocketStream::receive(Bytes& frame, const Deadline& deadline) {
  // An answer within microseconds is met awake; anything longer sleeps in poll().
  constexpr int awake_tries = 50;
  for (int tries = 0; ready_.empty(); ++tries) {
    if (read_some(deadline)) break;
    if (tries < awake_tries) {
      sched_yield();
    } else if (deadline.expired() || !wait_for(socket_.native_handle(), POLLIN, deadline)) {
      throw deadline.error("a frame from " + peer_);
    }
  }
  std::swap(frame, ready_.front());
  spare_ = std::move(ready_.front());
  ready_.pop_front();
}

void SocketStream::close() noexcept {
  boost::system::error_code ignored;
  socket_.shutdown(Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

}  // namespace powderlink::bridge
