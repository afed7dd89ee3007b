// SPDX-License-Identifier: GPL-3.0-or-later
/// \file board_pins.h
/// Which input is which; a free choice but for the need of an external interrupt on the first three.
/// The numbers of the Iono MKR are those of its library (Sfera Labs, sfera-labs/iono, src/Iono.h).
#ifndef KAT_BOARD_PINS_H
#define KAT_BOARD_PINS_H

#if defined(ARDUINO_ARCH_SAMD)
const uint8_t kBeamPin = 7;            // Iono DI5
const uint8_t kVibrationPin = 5;       // Iono DI6
const uint8_t kContactPin = A1;        // Iono DI1
const uint8_t kMagnetPin = 3;          // Iono DO1
const uint8_t kSensorsPin = 2;         // Iono DO2
const uint8_t kSwitchPin = A3;         // Iono AV3
const uint8_t kAccelerometerPin = A4;  // Iono AV4
const uint8_t kAnalogBits = 12;
#else  // Arduino Mega 2560: for trials at the desk, signals of 5 V
const uint8_t kBeamPin = 2;
const uint8_t kVibrationPin = 3;
const uint8_t kContactPin = 18;
const uint8_t kMagnetPin = 8;
const uint8_t kSensorsPin = 9;
const uint8_t kSwitchPin = A0;
const uint8_t kAccelerometerPin = A1;
const uint8_t kAnalogBits = 10;
#endif

// Level of the pin when it says yes. Turn round what your switch and divider turn round.
const uint8_t kBeamBlocked = HIGH;
const uint8_t kVibrating = HIGH;
const uint8_t kContactClosed = HIGH;

// What is wired; 0 for what is not.
const bool kHasSwitchChain = true;
const bool kHasAccelerometer = false;
const uint32_t kAnalogFullScale_mV = 30000;  // at the terminal, for the largest count; calibrate
const uint32_t kAccelerometerZero_mV = 1650, kAccelerometer_mV_per_g = 1;  // of the one you use

#endif
