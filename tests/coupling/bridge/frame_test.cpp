// SPDX-License-Identifier: GPL-3.0-or-later
// Encoder and decoder: what goes in comes out, and nothing else is let through.
#include "coupling/bridge/frame/frame.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "coupling/bridge/frame/checksum.h"
#include "tests/coupling/bridge/fails.h"
#include "tests/coupling/bridge/sample_frames.h"

namespace powderlink::test {
namespace {

using bridge::BridgeError;
using bridge::Bytes;
using bridge::ByteSpan;
using bridge::FrameView;
using Kind = BridgeError::Kind;

std::string decode_failure(ByteSpan frame, Kind kind, const std::string& words,
                           const bridge::FrameLimits& limits = {}) {
  FrameView view;
  return failure_of([&] { bridge::decode(frame, view, limits); }, kind, words);
}

/// Makes both checksums right again, so that the checks behind them are reached.
void seal(Bytes& frame) {
  const std::uint64_t payload =
      bridge::checksum(frame.data() + bridge::header_bytes, frame.size() - bridge::header_bytes);
  std::memcpy(frame.data() + 48, &payload, 8);
  const std::uint64_t header = bridge::checksum(frame.data(), 56);
  std::memcpy(frame.data() + 56, &header, 8);
}

template <class T>
Bytes with(std::size_t offset, T value, bool sealed = true) {
  Bytes frame = small_frame();
  std::memcpy(frame.data() + offset, &value, sizeof value);
  if (sealed) seal(frame);
  return frame;
}

TEST(Frame, RandomFieldsComeBackUnchanged) {
  Generator random(20240501);
  Bytes frame;
  FrameView view;
  for (int round = 0; round < 500; ++round) {
    const auto fields = random_fields(random, 200);
    const auto step = static_cast<std::int64_t>(random());
    const double time_s = 1e-7 * static_cast<double>(random() % 1000000);
    const std::string text(below(random, 30), 't');
    encode(frame, fields, step, time_s, text);
    ASSERT_EQ(bridge::frame_bytes(frame), frame.size());
    bridge::decode(frame, view);
    EXPECT_EQ(view.kind, bridge::MessageKind::fields);
    EXPECT_EQ(view.step, step);
    EXPECT_EQ(view.time_s, time_s);
    EXPECT_EQ(view.text, text);
    ASSERT_EQ(view.fields.size(), fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      EXPECT_EQ(view.fields[i].spec(), fields[i].spec());
      ASSERT_EQ(view.fields[i].rows, fields[i].rows());
      ASSERT_EQ(view.fields[i].data.size, fields[i].rows() * fields[i].spec().row_bytes());
      if (fields[i].rows() > 0) {
        EXPECT_EQ(0, std::memcmp(view.fields[i].data.data, fields[i].view().data(),
                                 view.fields[i].data.size));
      }
    }
  }
}

TEST(Frame, ValuesAreReadInTheTypeTheyHave) {
  const Bytes frame = small_frame();
  FrameView view;
  bridge::decode(frame, view);
  EXPECT_EQ(view.find("velocity")->values<double>(),
            (std::vector<double>{1.0, 2.0, 3.0, -4.0, -5.0, -6.0}));
  EXPECT_EQ(view.find("type")->values<std::int32_t>(), (std::vector<std::int32_t>{1, 2, 3}));
  EXPECT_EQ(view.find("mass"), nullptr);
  EXPECT_EQ("", failure_of([&] { view.find("type")->values<double>(); }, Kind::mismatch, "int32"));
}

TEST(Frame, EveryFlippedBitIsFound) {
  const Bytes whole = small_frame();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes frame = whole;
      frame[i] ^= std::byte{1} << bit;
      const bool version = i == 12 || i == 13;
      const std::string words = i < 8               ? "magic"
                                : i < 12            ? "byte order"
                                : version           ? "protocol version"
                                : i < 48 || i >= 56 ? "checksum"
                                                    : "checksum of the header";
      ASSERT_EQ("", decode_failure(frame, version ? Kind::wrong_version : Kind::bad_frame, words))
          << "byte " << i << " bit " << bit;
    }
  }
}

TEST(Frame, EveryTruncationIsFound) {
  const Bytes whole = small_frame();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    // A copy of exactly that size, so that a read beyond its end is noticed.
    const Bytes frame(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    ASSERT_EQ("", decode_failure(frame, Kind::bad_frame,
                                 size < bridge::header_bytes ? "frame: header" : "frame: size"));
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_EQ("", decode_failure(longer, Kind::bad_frame, "frame: size"));
}

// Offsets of small_frame(): header 64, text 8, first field at 72 (32 + 16 + 48 bytes), second at 168.
TEST(Frame, HostileNumbersWithRightChecksumsAreRefused) {
  constexpr std::size_t field = 72;
  constexpr auto huge = ~std::uint64_t{0};
  const auto bad = [](const Bytes& frame, const std::string& words) {
    EXPECT_EQ("", decode_failure(frame, Kind::bad_frame, words));
  };
  bad(with<std::uint32_t>(8, 0x04030201), "another kind of processor");
  bad(with<std::uint16_t>(14, 0), "message kind");
  bad(with<std::uint16_t>(14, 99), "message kind");
  bad(with<std::uint64_t>(16, huge), "size");
  bad(with<std::uint64_t>(16, 64), "size");
  bad(with<double>(32, std::nan("")), "time");
  bad(with<double>(32, HUGE_VAL), "time");
  bad(with<std::uint32_t>(40, 1u << 31), "number of fields");
  bad(with<std::uint32_t>(40, 200), "size");
  bad(with<std::uint32_t>(40, 3), "header of a field");
  bad(with<std::uint32_t>(40, 1), "end");
  bad(with<std::uint32_t>(44, ~0u), "text");
  bad(with<std::uint32_t>(44, 1u << 19), "size");
  bad(with<std::uint16_t>(field, 0xffff), "name and unit");
  bad(with<std::uint16_t>(field, 0), "name or unit");
  bad(with<std::uint16_t>(field + 2, 0xffff), "name and unit");
  bad(with<std::uint8_t>(field + 4, 0), "element type");
  bad(with<std::uint8_t>(field + 4, 4), "element type");
  bad(with<std::uint8_t>(field + 6, 1), "reserved");
  bad(with<std::uint32_t>(field + 8, 0), "shape");
  bad(with<std::uint32_t>(field + 12, ~0u), "shape");
  bad(with<std::uint64_t>(field + 16, huge), "rows of field velocity");
  bad(with<std::uint64_t>(field + 16, huge / 24 + 1), "rows of field velocity");
  bad(with<std::uint64_t>(field + 16, 3), "rows of field velocity");
  bad(with<std::uint64_t>(field + 24, huge), "rows of field velocity");
  bad(with<char>(field + 32, '\033'), "name or unit");
  bad(with<char>(field + 40, '\n'), "name or unit");

  Bytes twice;
  const bridge::Field one({"one", "1", bridge::scalar, bridge::ElementType::int32});
  encode(twice, {one, one});
  bad(twice, "field one");
}

TEST(Frame, OtherVersionsAreNamed) {
  EXPECT_EQ("", decode_failure(with<std::uint16_t>(12, 2), Kind::wrong_version, "given: 2"));
}

TEST(Frame, LimitsHoldBeforeMemoryIsTaken) {
  bridge::FrameLimits limits;
  limits.frame_bytes = 128;
  EXPECT_EQ("", decode_failure(small_frame(), Kind::bad_frame, "to 128 bytes", limits));
  Bytes buffer;
  bridge::FrameWriter writer(buffer, limits);
  const bridge::FieldSpec spec{"x", "m", bridge::vector3, bridge::ElementType::float64};
  writer.begin(bridge::MessageKind::fields, 0, 0.0);
  EXPECT_EQ("", failure_of([&] { writer.add(spec, ~std::size_t{0} / 2); }, Kind::bad_input, "x"));
  EXPECT_EQ("", failure_of([&] { writer.add(spec, 5); }, Kind::bad_input, "size"));
}

TEST(Frame, FieldsThatCannotBeSentAreRefused) {
  const auto refused = [](bridge::FieldSpec spec, const std::string& words) {
    EXPECT_EQ("", failure_of([&] { bridge::check(spec); }, Kind::bad_input, words));
  };
  refused({"", "m", bridge::scalar}, "name");
  refused({"two words", "m", bridge::scalar}, "name");
  refused({std::string(65, 'x'), "m", bridge::scalar}, "name");
  refused({"x", "", bridge::scalar}, "unit");
  refused({"x", std::string(33, 'm'), bridge::scalar}, "unit");
  refused({"x", "m", {0, 1}}, "shape");
  refused({"x", "m", {1, 65}}, "shape");
  Bytes buffer;
  bridge::FrameWriter writer(buffer);
  writer.begin(bridge::MessageKind::fields, 0, 0.0);
  const std::vector<std::int32_t> integers(3);
  EXPECT_EQ("",
            failure_of(
                [&] {
                  writer.add({"x", "m", bridge::scalar}, bridge::ColumnView(integers.data(), 3));
                },
                Kind::bad_input, "int32"));
  EXPECT_EQ("", failure_of([&] { writer.begin(bridge::MessageKind::fields, 0, std::nan("")); },
                           Kind::bad_input, "time"));
}

TEST(Frame, BuffersAreReused) {
  Bytes frame;
  Generator random(1);
  const std::vector<bridge::Field> fields = {random_field(random, "a", 1000)};
  encode(frame, fields);
  const std::byte* before = frame.data();
  for (int i = 0; i < 10; ++i) encode(frame, fields, i);
  EXPECT_EQ(before, frame.data());
}

}  // namespace
}  // namespace powderlink::test
