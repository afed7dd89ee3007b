// SPDX-License-Identifier: GPL-3.0-or-later
// Binds the core of the Kinetic Adhesion Test to the Iono MKR (Arduino MKR WiFi 1010): pins, clock,
// interrupts, USB serial and BLE. Whatever decides anything is in ../core.
#include <kat_console.h>

#include "board_pins.h"

#if defined(ARDUINO_SAMD_MKRWIFI1010)
#define KAT_BLE 1
#include <ArduinoBLE.h>
#endif

namespace {

uint32_t analog_mV(uint8_t pin) {
  return static_cast<uint32_t>(analogRead(pin)) * kAnalogFullScale_mV / ((1UL << kAnalogBits) - 1UL);
}

class ArduinoBoard final : public kat::Board {
 public:
  uint32_t now_us() override { return micros(); }
  void set_magnet(bool on) override { digitalWrite(kMagnetPin, on ? HIGH : LOW); }
  void set_sensors(bool on) override { digitalWrite(kSensorsPin, on ? HIGH : LOW); }
  bool beam_blocked() override { return digitalRead(kBeamPin) == kBeamBlocked; }
  bool contact_closed() override { return digitalRead(kContactPin) == kContactClosed; }
  uint32_t switch_mV() override { return kHasSwitchChain ? analog_mV(kSwitchPin) : uint32_t(kat::kNoValue); }
  uint32_t acceleration_mg() override {
    if (!kHasAccelerometer) return kat::kNoValue;
    const uint32_t mV = analog_mV(kAccelerometerPin);
    const uint32_t off = mV > kAccelerometerZero_mV ? mV - kAccelerometerZero_mV : kAccelerometerZero_mV - mV;
    return off * 1000UL / kAccelerometer_mV_per_g;
  }
};

class UsbOutput final : public kat::Output {
 public:
  bool ready() override { return Serial; }
  void write(const char* text, uint16_t length) override {
    // Nobody listens: a full buffer must not hold the loop.
    if (Serial) Serial.write(reinterpret_cast<const uint8_t*>(text), length);
  }
};

ArduinoBoard board;
kat::Machine machine(board);
UsbOutput usb_output;
kat::Console usb(machine, usb_output);

// The time first, then the level: both edges of a pin share an interrupt.
void beam_edge() {
  const uint32_t time = micros();
  machine.edge(board.beam_blocked() ? kat::EdgeKind::beam_blocked : kat::EdgeKind::beam_clear, time);
}
void contact_edge() {
  const uint32_t time = micros();
  machine.edge(board.contact_closed() ? kat::EdgeKind::contact_closed : kat::EdgeKind::contact_open, time);
}
void vibration_edge() { machine.edge(kat::EdgeKind::vibration, micros()); }

#if defined(KAT_BLE)
// The UART service that Nordic Semiconductor defined and most telephone terminals know.
BLEService uart("6E400001-B5A3-F393-E0A9-E50E24DCCA9E");
BLECharacteristic to_device("6E400002-B5A3-F393-E0A9-E50E24DCCA9E", BLEWrite | BLEWriteWithoutResponse, 20);
BLECharacteristic from_device("6E400003-B5A3-F393-E0A9-E50E24DCCA9E", BLENotify, 20);
bool ble_on = false;

class BleOutput final : public kat::Output {
 public:
  bool ready() override { return ble_on && BLE.connected() && from_device.subscribed(); }
  void write(const char* text, uint16_t length) override {
    if (!ready()) return;
    for (uint16_t at = 0; at < length; at += 20) {
      const int part = length - at < 20 ? length - at : 20;
      from_device.writeValue(reinterpret_cast<const uint8_t*>(text) + at, part);
    }
  }
};

BleOutput ble_output;
kat::Console ble(machine, ble_output);

void begin_ble() {
  ble_on = BLE.begin();  // without the radio the device works over USB
  if (!ble_on) return;
  BLE.setLocalName("KAT");
  BLE.setAdvertisedService(uart);
  uart.addCharacteristic(to_device);
  uart.addCharacteristic(from_device);
  BLE.addService(uart);
  BLE.advertise();
}

void poll_ble() {
  // The radio may take milliseconds and interrupts: not while something falls. The console on USB is
  // silent then too; what comes for it is refused, but for abort.
  if (!ble_on || machine.measuring()) return;
  BLE.poll();
  if (to_device.written()) {
    for (int i = 0; i < to_device.valueLength(); ++i) ble.receive(static_cast<char>(to_device.value()[i]));
  }
  ble.poll();
}
#else
void begin_ble() {}
void poll_ble() {}
#endif

}  // namespace

void setup() {
  pinMode(kMagnetPin, OUTPUT);
  pinMode(kSensorsPin, OUTPUT);
  board.set_magnet(false);
  board.set_sensors(false);
  pinMode(kBeamPin, INPUT);
  pinMode(kVibrationPin, INPUT);
  pinMode(kContactPin, INPUT);
#if defined(ARDUINO_ARCH_SAMD)
  analogReadResolution(kAnalogBits);
#endif
  attachInterrupt(digitalPinToInterrupt(kBeamPin), beam_edge, CHANGE);
  attachInterrupt(digitalPinToInterrupt(kContactPin), contact_edge, CHANGE);
  attachInterrupt(digitalPinToInterrupt(kVibrationPin), vibration_edge, kVibrating == HIGH ? RISING : FALLING);
  Serial.begin(115200);
  begin_ble();
}

void loop() {
  machine.poll();
  while (Serial.available() > 0) usb.receive(static_cast<char>(Serial.read()));
  usb.poll();
  poll_ble();
}
