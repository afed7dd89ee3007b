// SPDX-License-Identifier: GPL-3.0-or-later
/// \file checksum.h
/// XXH3 of some bytes: at the speed of memory, where a CRC-32 would cost more than the transport.
/// Tests: tests/coupling/bridge/frame_test.cpp, tests/coupling/bridge/frame_fuzz_test.cpp
#pragma once

#include <cstddef>
#include <cstdint>

namespace powderlink::bridge {

std::uint64_t checksum(const std::byte* data, std::size_t bytes);

}  // namespace powderlink::bridge
