// SPDX-License-Identifier: GPL-3.0-or-later
/// \file kat_ring.h
/// Edges on their way from interrupts to the loop. One producer (interrupts that do not interrupt
/// each other, as on SAMD21's EIC and on AVR), one consumer. A full ring drops the new edge and keeps
/// that in mind: a measurement with a lost edge must not look whole.
/// Tests: tests/kat_firmware/parts_test.cpp
#ifndef KAT_RING_H
#define KAT_RING_H

#include <stdint.h>

namespace kat {

enum class EdgeKind : uint8_t { beam_blocked, beam_clear, contact_closed, contact_open, vibration };

struct Edge {
  EdgeKind kind;
  uint32_t time_us;
};

enum : uint8_t { kRingSize = 32 };  // a power of two; one place stays free

class EdgeRing {
 public:
  EdgeRing() : head_(0), tail_(0), overflowed_(false) {}
  void push(EdgeKind kind, uint32_t time_us);  ///< by interrupts
  bool pop(Edge& edge);                        ///< by the loop
  bool overflowed() const { return overflowed_; }
  void clear();  ///< by the loop while no interrupt pushes

 private:
  struct Slot {
    EdgeKind kind;
    uint32_t time_us;
  };
  // Volatile: the order of accesses is that of the text, which is all that one core needs.
  volatile Slot slots_[kRingSize];
  volatile uint8_t head_, tail_;
  volatile bool overflowed_;
};

}  // namespace kat

#endif
