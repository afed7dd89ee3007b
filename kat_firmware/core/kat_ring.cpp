// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_ring.h"

namespace kat {

void EdgeRing::push(EdgeKind kind, uint32_t time_us) {
  const uint8_t head = head_;
  const uint8_t next = static_cast<uint8_t>((head + 1U) % kRingSize);
  if (next == tail_) {
    overflowed_ = true;
    return;
  }
  slots_[head].kind = kind;
  slots_[head].time_us = time_us;
  head_ = next;
}

bool EdgeRing::pop(Edge& edge) {
  const uint8_t tail = tail_;
  if (tail == head_) return false;
  edge.kind = slots_[tail].kind;
  edge.time_us = slots_[tail].time_us;
  tail_ = static_cast<uint8_t>((tail + 1U) % kRingSize);
  return true;
}

void EdgeRing::clear() {
  tail_ = head_;
  overflowed_ = false;
}

}  // namespace kat
