// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/kat/reduced/critical_diameter.h"

#include <gtest/gtest.h>

#include "analysis/kat/study/material_library.h"

namespace powderlink::analysis {
namespace {

KatSetup glass(double energy, const physics::StopPulse& stop = physics::StopPulse::instant()) {
  KatSetup s;
  s.particle = s.substrate = find_material("borosilicate_glass");
  s.work_of_adhesion_J_m2 = energy;
  s.stop = stop;
  return s;
}

TEST(CriticalDiameter, BracketsWithTheGivenTolerance) {
  const ReducedModel model(glass(50.0));
  for (const double tolerance : {1e-2, 1e-4}) {
    const CriticalDiameter d = critical_diameter(model, 2.0, tolerance);
    ASSERT_TRUE(d.found());
    EXPECT_FALSE(model.detaches(d.largest_attached_m, 2.0));
    EXPECT_TRUE(model.detaches(d.smallest_detached_m, 2.0));
    EXPECT_LE(d.smallest_detached_m / d.largest_attached_m - 1.0, tolerance);
    EXPECT_GT(d.smallest_detached_m, d.largest_attached_m);
  }
}

TEST(CriticalDiameter, SaysWhenEverythingLeavesOrNothingDoes) {
  const CriticalDiameter all = critical_diameter(ReducedModel(glass(0.001)), 6.0);
  EXPECT_EQ(all.state, CriticalDiameter::State::everything_detaches);
  EXPECT_EQ(all.diameter_m, kSmallestDiameter_m);
  EXPECT_NE(all.text_um().find("everything"), std::string::npos);
  const CriticalDiameter none = critical_diameter(ReducedModel(glass(1000.0)), 0.1);
  EXPECT_EQ(none.state, CriticalDiameter::State::nothing_detaches);
  EXPECT_EQ(none.diameter_m, kLargestDiameter_m);
  EXPECT_NE(none.text_um().find("nothing"), std::string::npos);
}

TEST(CriticalDiameter, TheoryNamesItsLimit) {
  EXPECT_STREQ(theory_diameter(ReducedModel(glass(50.0)), 2.0).limit, "instant stop");
  EXPECT_STREQ(
      theory_diameter(ReducedModel(glass(0.09, physics::StopPulse::half_sine(1e-4))), 3.0).limit,
      "slow stop");
  // A stop of a nanosecond is instant for every grain.
  EXPECT_STREQ(
      theory_diameter(ReducedModel(glass(50.0, physics::StopPulse::half_sine(1e-9))), 2.0).limit,
      "instant stop");
}

}  // namespace
}  // namespace powderlink::analysis
