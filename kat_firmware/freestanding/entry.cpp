// SPDX-License-Identifier: GPL-3.0-or-later
// Links the whole core without a C library and without Arduino, so that its size is known and nothing
// else creeps in. Not flashed: the registers that it would need are Arduino's business.
#include "kat_console.h"

// What compilers may call of their own accord.
extern "C" {
void __cxa_pure_virtual() {
  for (;;) {
  }
}
void* memset(void* to, int value, unsigned size) {
  volatile uint8_t* bytes = static_cast<volatile uint8_t*>(to);
  for (unsigned i = 0; i < size; ++i) bytes[i] = static_cast<uint8_t>(value);
  return to;
}
void* memcpy(void* to, const void* from, unsigned size) {
  volatile uint8_t* bytes = static_cast<volatile uint8_t*>(to);
  for (unsigned i = 0; i < size; ++i) bytes[i] = static_cast<const uint8_t*>(from)[i];
  return to;
}
}

namespace {

volatile uint32_t registers[8];

class Registers final : public kat::Board, public kat::Output {
 public:
  uint32_t now_us() override { return registers[0]; }
  void set_magnet(bool on) override { registers[1] = on; }
  void set_sensors(bool on) override { registers[2] = on; }
  bool beam_blocked() override { return registers[3] != 0; }
  bool contact_closed() override { return registers[4] != 0; }
  uint32_t switch_mV() override { return registers[5]; }
  uint32_t acceleration_mg() override { return registers[6]; }
  bool ready() override { return true; }
  void write(const char* text, uint16_t length) override {
    for (uint16_t i = 0; i < length; ++i) registers[7] = static_cast<uint8_t>(text[i]);
  }
};

}  // namespace

extern "C" void kat_entry() {
  Registers board;
  kat::Machine machine(board);
  kat::Console console(machine, board);
  for (;;) {
    machine.edge(static_cast<kat::EdgeKind>(registers[3]), registers[0]);
    machine.poll();
    console.poll();
    console.receive(static_cast<char>(registers[7]));
  }
}
