// SPDX-License-Identifier: GPL-3.0-or-later
// Hundreds of thousands of damaged frames, the same on every machine: each is either refused with a
// BridgeError or gives a view that lies within its bytes. Under the sanitizers a stray read ends it.
#include <gtest/gtest.h>

#include "coupling/bridge/frame/checksum.h"
#include "coupling/bridge/transport/session.h"
#include "tests/coupling/bridge/sample_frames.h"

namespace powderlink::test {
namespace {

using bridge::Bytes;

/// Reads everything a user of the view could read.
std::uint64_t read_all(const bridge::FrameView& view) {
  std::uint64_t sum =
      bridge::checksum(reinterpret_cast<const std::byte*>(view.text.data()), view.text.size());
  for (const bridge::FieldSlice& field : view.fields) {
    sum += field.name.size() + field.unit.size() + field.shape.components() * field.rows;
    if (field.data.size > 0) sum += bridge::checksum(field.data.data, field.data.size);
  }
  return sum;
}

void seal(Bytes& frame) {
  if (frame.size() < bridge::header_bytes) return;
  const std::uint64_t size = frame.size();
  std::memcpy(frame.data() + 16, &size, 8);
  const std::uint64_t payload =
      bridge::checksum(frame.data() + bridge::header_bytes, frame.size() - bridge::header_bytes);
  std::memcpy(frame.data() + 48, &payload, 8);
  const std::uint64_t header = bridge::checksum(frame.data(), 56);
  std::memcpy(frame.data() + 56, &header, 8);
}

std::byte interesting(Generator& random) {
  constexpr unsigned char values[] = {0, 1, 2, 3, 7, 8, 64, 0x7f, 0x80, 0xfe, 0xff};
  return below(random, 2) == 0 ? static_cast<std::byte>(values[below(random, sizeof values)])
                               : static_cast<std::byte>(random() & 0xff);
}

void mutate(Bytes& frame, Generator& random) {
  for (std::size_t changes = 1 + below(random, 4); changes > 0; --changes) {
    if (frame.empty()) return;
    switch (below(random, 8)) {
      case 0:
        bridge::resize(frame, below(random, frame.size() + 1));
        break;
      case 1: {  // grows by unset bytes, which are set here
        const std::size_t before = frame.size();
        bridge::resize(frame, before + below(random, 64));
        for (std::size_t i = before; i < frame.size(); ++i) frame[i] = interesting(random);
        break;
      }
      case 2: {  // a number of 8 bytes becomes another one
        const std::size_t words = frame.size() / 8;
        if (words == 0) break;
        const std::uint64_t value = ~std::uint64_t{0} >> below(random, 64);
        std::memcpy(frame.data() + 8 * below(random, words), &value, 8);
        break;
      }
      default:
        frame[below(random, frame.size())] = interesting(random);
    }
  }
}

TEST(FrameFuzz, DamagedFramesNeverCrash) {
  Generator random(987654321);
  bridge::FrameView view;
  std::vector<Bytes> seeds;
  for (int i = 0; i < 50; ++i) {
    seeds.emplace_back();
    encode(seeds.back(), random_fields(random, 8), i, 1e-6 * i);
  }
  int accepted = 0;
  std::uint64_t sum = 0;
  constexpr int cases = 200000;
  for (int i = 0; i < cases; ++i) {
    Bytes mutated = seeds[below(random, seeds.size())];
    mutate(mutated, random);
    // Most with right checksums: else nothing behind the checksum would ever be tried.
    if (below(random, 8) != 0) seal(mutated);
    mutated.shrink_to_fit();
    try {
      bridge::decode(mutated, view);
      ++accepted;
      sum += read_all(view);
    } catch (const bridge::BridgeError& e) {
      ASSERT_TRUE(e.kind() == bridge::BridgeError::Kind::bad_frame ||
                  e.kind() == bridge::BridgeError::Kind::wrong_version)
          << e.what();
    }
  }
  // Some damage hits only data; if nothing or all passed, the test would not test.
  EXPECT_GT(accepted, cases / 100);
  EXPECT_LT(accepted, cases - cases / 10);
  EXPECT_NE(sum, 0u);
}

TEST(FrameFuzz, NoiseNeverCrashes) {
  Generator random(13);
  bridge::FrameView view;
  for (int i = 0; i < 50000; ++i) {
    Bytes noise;
    bridge::resize(noise, below(random, 200));
    for (std::byte& byte : noise) byte = static_cast<std::byte>(random() & 0xff);
    EXPECT_THROW(bridge::decode(noise, view), bridge::BridgeError);
  }
}

TEST(FrameFuzz, DamagedHellosNeverCrash) {
  Generator random(77);
  bridge::Hello hello;
  hello.role = "dem";
  hello.case_name = "pipe";
  hello.offers = {{"velocity", "m/s", bridge::vector3, bridge::ElementType::float64}};
  hello.needs = {{"drag", "N", bridge::vector3, bridge::ElementType::float64}};
  const std::string whole = bridge::to_text(hello);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole;
    for (std::size_t changes = 1 + below(random, 3); changes > 0 && !text.empty(); --changes) {
      if (below(random, 8) == 0) {
        text.resize(below(random, text.size() + 1));
      } else {
        text[below(random, text.size())] = static_cast<char>(random() & 0xff);
      }
    }
    try {
      bridge::hello_from_text(text);
      ++accepted;
    } catch (const bridge::BridgeError&) {
      continue;
    }
  }
  EXPECT_LT(accepted, 20000);
}

}  // namespace
}  // namespace powderlink::test
