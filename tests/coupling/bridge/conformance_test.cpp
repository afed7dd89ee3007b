// SPDX-License-Identifier: GPL-3.0-or-later
// The conformance suite on the transports that work between two threads; bridge_mpi_program runs it
// between two programs.
#include "tests/coupling/bridge/conformance.h"

#include <cctype>
#include <thread>

#include <gtest/gtest.h>

#include "tests/coupling/bridge/temporary_folder.h"
#include "tests/coupling/bridge/transport_pairs.h"

namespace powderlink::test {
namespace {

class Conformance : public ::testing::TestWithParam<std::tuple<std::string, ConformanceCase>> {};

std::string outcome(Side side, const MakeTransport& make) {
  try {
    side(make());
    return {};
  } catch (const std::exception& e) {
    return e.what();
  }
}

TEST_P(Conformance, BothSidesAreContent) {
  const auto& [kind, test] = GetParam();
  const TemporaryFolder folder;
  auto makers = transport_makers(kind, folder.path());
  std::string second;
  std::thread thread([&, side = test.second] { second = outcome(side, makers.second); });
  const std::string first = outcome(test.first, makers.first);
  thread.join();
  EXPECT_EQ("", first);
  EXPECT_EQ("", second);
}

INSTANTIATE_TEST_SUITE_P(Transports, Conformance,
                         ::testing::Combine(::testing::Values(BRIDGE_TRANSPORTS),
                                            ::testing::ValuesIn(conformance_cases())),
                         [](const auto& info) {
                           return std::get<0>(info.param) + "_" + std::get<1>(info.param).name;
                         });

}  // namespace
}  // namespace powderlink::test
