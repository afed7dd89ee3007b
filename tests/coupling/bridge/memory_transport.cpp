// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupling/bridge/memory_transport.h"

#include <condition_variable>
#include <deque>
#include <mutex>

#include "coupling/bridge/frame/frame.h"

namespace powderlink::bridge {

namespace {

/// What both ends share: frames that end i has still to read, and whether end i was closed.
struct Channel {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Bytes> inbox[2];
  bool closed[2] = {false, false};
};

class MemoryTransport : public Transport {
 public:
  MemoryTransport(std::shared_ptr<Channel> channel, int end)
      : channel_(std::move(channel)), end_(end), peer_(end == 0 ? "memory:1" : "memory:0") {}
  ~MemoryTransport() override { MemoryTransport::close(); }

  void send(Bytes& frame, const Deadline&) override {
    const std::lock_guard lock(channel_->mutex);
    if (channel_->closed[1 - end_] || channel_->closed[end_]) throw lost(peer_, "closed");
    channel_->inbox[1 - end_].push_back(frame);
    channel_->changed.notify_all();
  }

  void receive(Bytes& frame, const Deadline& deadline) override {
    std::unique_lock lock(channel_->mutex);
    auto& inbox = channel_->inbox[end_];
    const bool woken = channel_->changed.wait_for(
        lock, std::chrono::duration<double>(deadline.remaining_s()),
        [&] { return !inbox.empty() || channel_->closed[1 - end_] || channel_->closed[end_]; });
    if (!woken) throw deadline.error("a frame from " + peer_);
    if (inbox.empty() || channel_->closed[end_]) throw lost(peer_, "closed");
    frame = std::move(inbox.front());
    inbox.pop_front();
  }

  const std::string& peer() const override { return peer_; }

  void close() noexcept override {
    const std::lock_guard lock(channel_->mutex);
    channel_->closed[end_] = true;
    channel_->changed.notify_all();
  }

 private:
  std::shared_ptr<Channel> channel_;
  int end_;
  std::string peer_;
};

}  // namespace

std::pair<std::unique_ptr<Transport>, std::unique_ptr<Transport>> memory_transport_pair() {
  auto channel = std::make_shared<Channel>();
  return {std::make_unique<MemoryTransport>(channel, 0),
          std::make_unique<MemoryTransport>(channel, 1)};
}

}  // namespace powderlink::bridge
