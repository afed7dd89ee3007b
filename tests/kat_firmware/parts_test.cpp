// SPDX-License-Identifier: GPL-3.0-or-later
/// \file parts_test.cpp
/// Ring, contacts, velocity, configuration and switch chain, each by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "kat_firmware/core/kat_board.h"
#include "kat_firmware/core/kat_config.h"
#include "kat_firmware/core/kat_contacts.h"
#include "kat_firmware/core/kat_line.h"
#include "kat_firmware/core/kat_ring.h"
#include "kat_firmware/core/kat_velocity.h"
#include "tests/kat_firmware/simulated_board.h"

namespace kat {
namespace {

TEST(EdgeRing, KeepsTheOrderAndTellsOfLoss) {
  EdgeRing ring;
  Edge edge{};
  EXPECT_FALSE(ring.pop(edge));
  for (uint32_t round = 0; round < 10; ++round) {
    for (uint32_t i = 0; i < kRingSize - 1U; ++i) ring.push(EdgeKind::vibration, i + round);
    EXPECT_FALSE(ring.overflowed());
    for (uint32_t i = 0; i < kRingSize - 1U; ++i) {
      ASSERT_TRUE(ring.pop(edge));
      EXPECT_EQ(edge.time_us, i + round);
    }
    EXPECT_FALSE(ring.pop(edge));
  }
  for (uint32_t i = 0; i < kRingSize; ++i) ring.push(EdgeKind::beam_clear, i);
  EXPECT_TRUE(ring.overflowed());
  ring.clear();
  EXPECT_FALSE(ring.overflowed());
  EXPECT_FALSE(ring.pop(edge));
}

TEST(Contacts, MeasuresEveryBounceAcrossTheClocksEnd) {
  Contacts c;
  const uint32_t start = UINT32_MAX - 20;
  EXPECT_TRUE(c.edge(true, start, 5));
  EXPECT_EQ(c[0].duration_us, static_cast<uint32_t>(kNoValue));
  EXPECT_TRUE(c.closed());
  EXPECT_FALSE(c.edge(true, start + 1, 5));
  EXPECT_TRUE(c.edge(false, start + 101, 5));
  EXPECT_FALSE(c.edge(false, start + 102, 5));
  EXPECT_EQ(c[0].duration_us, 101U);
  EXPECT_TRUE(c.edge(true, start + 106, 5));  // a gap of 5 us is chatter
  EXPECT_EQ(c.finished(), 0U);
  EXPECT_TRUE(c.edge(false, start + 120, 5));
  EXPECT_EQ(c[0].duration_us, 120U);
  EXPECT_EQ(c[0].chatter, 1U);
  EXPECT_TRUE(c.edge(true, start + 126, 5));  // one of 6 us is not
  EXPECT_TRUE(c.edge(false, start + 127, 5));
  EXPECT_EQ(c.total(), 2U);
  EXPECT_EQ(c[1].duration_us, 1U);
}

TEST(Contacts, CountsThoseThatItDoesNotKeep) {
  Contacts c;
  for (uint32_t i = 0; i < 20; ++i) {
    c.edge(true, 1000 * i, 5);
    c.edge(false, 1000 * i + 10, 5);
  }
  c.edge(true, 19012, 5);  // chatter of one that is not kept
  c.edge(false, 19020, 5);
  EXPECT_EQ(c.total(), 20U);
  EXPECT_EQ(c.finished(), 20U);
  EXPECT_EQ(c.kept(), static_cast<uint8_t>(kContactLimit));
  EXPECT_EQ(c[kContactLimit - 1].start_us, 1000U * (kContactLimit - 1U));
  EXPECT_EQ(c[kContactLimit - 1].chatter, 0U);
}

TEST(SquareRoot, IsTheLargestWhoseSquareIsNotAbove) {
  for (const uint64_t x :
       {0ULL, 1ULL, 2ULL, 3ULL, 4ULL, 99ULL, 100ULL, 1ULL << 32, (1ULL << 62) - 1, ~0ULL,
        18446744065119617025ULL, 18446744065119617024ULL}) {
    const uint64_t root = square_root(x);
    EXPECT_LE(root * root, x);
    EXPECT_TRUE(root == UINT32_MAX || (root + 1) * (root + 1) > x);
  }
}

/// The law in floating point, with the time unrounded: what is left is the rounding of the integers
/// and of the clock. dv/v <= (w/v)(h/t)/v dt/t with dt = 1 us; below 1e-3 for every geometry here.
TEST(FreeFall, IsTheClosedFormOfTheDrop) {
  constexpr double largest_error = 1e-3;  // demanded of the device
  for (int mm = 10; mm <= 500; ++mm) {
    for (const double carrier_m : {0.004, 0.008, 0.02, 0.05}) {
      for (const double share : {0.6, 0.9, 0.99}) {  // of the fall is below the beam
        const double h = mm * 1e-3;
        const double beam_m = std::min(0.2, share * h);
        if (beam_m < carrier_m) continue;
        const double enter = std::sqrt(2.0 * (h - beam_m) / kGravity_m_s2);
        const double leave = std::sqrt(2.0 * (h - beam_m + carrier_m) / kGravity_m_s2);
        const double touch = std::sqrt(2.0 * h / kGravity_m_s2);
        const auto um = [](double m) { return static_cast<uint32_t>(std::lround(m * 1e6)); };
        const Fall fall = free_fall(um(carrier_m), um(beam_m), um(leave - enter));
        const double v = std::sqrt(2.0 * kGravity_m_s2 * h);
        EXPECT_NEAR(fall.velocity_um_s * 1e-6 / v, 1.0, largest_error)
            << mm << " mm, carrier " << carrier_m << ", beam " << beam_m;
        EXPECT_NEAR(fall.flight_us * 1e-6, touch - leave, 1e-3 * touch + 2e-6);
      }
    }
  }
}

TEST(FreeFall, RefusesWhatIsNone) {
  EXPECT_EQ(free_fall(10000, 30000, 0).velocity_um_s, 0U);
  EXPECT_EQ(free_fall(10000, 30000, 1000001).velocity_um_s, 0U);
  EXPECT_EQ(free_fall(10000, 9999, 5000).velocity_um_s, 0U);
  EXPECT_EQ(free_fall(0, 30000, 5000).velocity_um_s, 0U);
  EXPECT_EQ(free_fall(200000, 300000, 1).velocity_um_s, 0U);     // faster than any drop
  EXPECT_EQ(free_fall(10000, 30000, 100000).velocity_um_s, 0U);  // slower than from rest
  EXPECT_GT(free_fall(10000, 10000, 5000).velocity_um_s, 0U);
  EXPECT_EQ(free_fall(10000, 10000, 5000).flight_us, 0U);
}

TEST(FreeFall, FlightAgreesWithinItsTolerance) {
  EXPECT_TRUE(flight_agrees(10550, 10000, 50));
  EXPECT_FALSE(flight_agrees(10551, 10000, 50));
  EXPECT_TRUE(flight_agrees(9450, 10000, 50));
  EXPECT_FALSE(flight_agrees(9449, 10000, 50));
}

TEST(ClosedSwitches, AreTheVoltagesOfTheChain) {
  EXPECT_EQ(closed_switches(18000), 3U);
  EXPECT_EQ(closed_switches(16000), 2U);
  EXPECT_EQ(closed_switches(12000), 1U);
  EXPECT_EQ(closed_switches(0), 0U);
  for (const uint32_t none : {5000U, 24000U, uint32_t(kNoValue)}) {
    EXPECT_EQ(closed_switches(none), static_cast<uint32_t>(kNoValue));
  }
}

Code set(Config& config, const char* key, const char* value, const char* key2 = nullptr,
         const char* value2 = nullptr) {
  LineWriter writer("set");
  if (key != nullptr) writer.text(key, value);
  if (key2 != nullptr) writer.text(key2, value2);
  const char* text = writer.finish();
  Line line;
  EXPECT_EQ(line.parse(text, static_cast<uint16_t>(writer.length() - 1)), Code::none);
  return set_config(config, line);
}

TEST(Config, TakesEveryKeyWithinItsLimitsOnly) {
  for (uint8_t i = 0; i < kConfigKeys; ++i) {
    const ConfigKey& key = config_key(i);
    const auto code_for = [&](uint64_t value) {
      Config config;
      config.carrier_um = 1000;
      config.beam_um = 1000000;
      const Code code = set(config, key.name, std::to_string(value).c_str());
      EXPECT_TRUE(code != Code::none || config.*key.value == value);
      return code;
    };
    EXPECT_EQ(code_for(key.smallest), Code::none) << key.name;
    EXPECT_EQ(code_for(key.largest), Code::none) << key.name;
    EXPECT_EQ(code_for(key.largest + 1ULL), Code::out_of_range) << key.name;
    EXPECT_TRUE(key.smallest == 0 || code_for(key.smallest - 1ULL) == Code::out_of_range)
        << key.name;
    // Limits in time must be told apart from times before.
    EXPECT_LT(key.largest, 0x80000000U);
    const Config initial;
    EXPECT_GE(initial.*key.value, key.smallest);
    EXPECT_LE(initial.*key.value, key.largest);
  }
}

TEST(Config, ChangesAllOrNothing) {
  Config config;
  const uint32_t before = config.carrier_um;
  EXPECT_EQ(set(config, "carrier_um", "12000", "nonsense", "1"), Code::unknown_key);
  EXPECT_EQ(set(config, "carrier_um", "12000", "beam_um", "ten"), Code::bad_value);
  EXPECT_EQ(set(config, "carrier_um", "12000", "beam_um", "11999"), Code::beam_below_carrier);
  EXPECT_EQ(set(config, nullptr, nullptr), Code::bad_value);
  EXPECT_EQ(config.carrier_um, before);
  EXPECT_EQ(set(config, "carrier_um", "12000", "beam_um", "12000"), Code::none);
  EXPECT_EQ(config.beam_um, 12000U);
}

}  // namespace
}  // namespace kat
