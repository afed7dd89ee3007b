#!/usr/bin/env bash
# build.sh FOLDER: what of the firmware Debian's compilers can build, and its size:
# the core for Cortex-M0+ (SAMD21 of the Arduino MKR), linked without any library but libgcc, and the
# sketch for an Arduino Mega 2560. A compiler that is not there is named and left out.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=${1:?folder for objects}
mkdir -p "$out"
warnings=(-Wall -Wextra -Wpedantic -Werror)
small=(-std=c++11 -Os -ffunction-sections -fdata-sections -fno-exceptions -fno-rtti -fno-threadsafe-statics)

cortex() {
  local flags=(-mcpu=cortex-m0plus -mthumb -ffreestanding "${small[@]}" "${warnings[@]}") objects=()
  for source in "$here"/core/*.cpp "$here"/freestanding/entry.cpp; do
    local object
    object=$out/m0_$(basename "$source" .cpp).o
    arm-none-eabi-g++ "${flags[@]}" -I"$here/core" -c "$source" -o "$object"
    objects+=("$object")
  done
  # Anything that the core needs beyond libgcc fails here by name.
  arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb -nostdlib -Wl,--gc-sections,--entry=kat_entry \
    "${objects[@]}" -lgcc -o "$out/kat_core.elf"
  echo "core for Cortex-M0+ (of 256 KiB flash, 32 KiB RAM):"
  arm-none-eabi-size "$out/kat_core.elf"
}

avr() {
  local arduino=/usr/share/arduino/hardware/arduino/avr
  local flags=(-mmcu=atmega2560 -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_AVR_MEGA2560 -DARDUINO_ARCH_AVR
    "${small[@]}" -I"$here/core") objects=()
  local headers=(-I"$arduino/cores/arduino" -I"$arduino/variants/mega")
  for source in "$here"/core/*.cpp; do
    local object
    object=$out/avr_$(basename "$source" .cpp).o
    avr-g++ "${flags[@]}" "${warnings[@]}" -c "$source" -o "$object"
    objects+=("$object")
  done
  avr-g++ "${flags[@]}" -Wall -Werror "${headers[@]}" -x c++ -include Arduino.h \
    -c "$here/kat_device/kat_device.ino" -o "$out/avr_sketch.o"
  objects+=("$out/avr_sketch.o")
  # Arduino's own part, with its own flags.
  for source in "$arduino"/cores/arduino/*.c "$arduino"/cores/arduino/*.cpp "$arduino"/cores/arduino/*.S; do
    local object
    object=$out/avr_arduino_$(basename "$source").o
    local language=(avr-gcc)
    if [[ $source == *.cpp ]]; then language=(avr-g++ -std=gnu++11 -fno-threadsafe-statics); fi
    "${language[@]}" -w -mmcu=atmega2560 -DF_CPU=16000000L -DARDUINO=10819 -Os -ffunction-sections -fdata-sections \
      -DDECIMAL_DIG=__DECIMAL_DIG__ \
      "${headers[@]}" -c "$source" -o "$object"
    objects+=("$object")
  done
  avr-gcc -mmcu=atmega2560 -Os -Wl,--gc-sections "${objects[@]}" -lm -o "$out/kat_device_mega.elf"
  echo "sketch for Arduino Mega 2560 (of 248 KiB flash, 8 KiB RAM):"
  avr-size "$out/kat_device_mega.elf"
}

if command -v arm-none-eabi-g++ >/dev/null; then cortex; else
  echo "left out: Cortex-M0+ (package gcc-arm-none-eabi is not installed)"
fi
if command -v avr-g++ >/dev/null && [[ -d /usr/share/arduino/hardware/arduino/avr ]]; then avr; else
  echo "left out: AVR (packages gcc-avr, avr-libc, arduino-core-avr are not all installed)"
fi
