// SPDX-License-Identifier: GPL-3.0-or-later
// The line of fix couple/bridge: what is taken, and what is refused with four parts.
#include "liggghts_styles/couple_bridge/couple_bridge_options.h"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/invalid_input.h"

namespace powderlink::host {
namespace {

CoupleBridgeOptions parse(const std::string& line) {
  std::istringstream in("gas all couple/bridge " + line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return CoupleBridgeOptions::parse(static_cast<int>(arguments.size()), arguments.data(), "pipe");
}

TEST(CoupleBridgeOptions, DefaultsAreThoseOfOneMpirun) {
  const CoupleBridgeOptions o = parse("every 25");
  EXPECT_EQ(o.every, 25);
  EXPECT_FALSE(o.socket);
  EXPECT_EQ(o.timeout_s, 120.0);
  EXPECT_EQ(o.case_name, "pipe");
  EXPECT_EQ(o.checkpoint_prefix, "post/restart.");
}

TEST(CoupleBridgeOptions, SocketMeetsThroughAFileUnlessAnAddressIsGiven) {
  CoupleBridgeOptions o = parse("every 1 transport socket");
  EXPECT_EQ(o.rendezvous_file, "bridge.address");
  EXPECT_FALSE(o.listens);
  o = parse("transport socket address host:99 token secret listen every 2 timeout 5 case bed");
  EXPECT_EQ(o.address, "host:99");
  EXPECT_EQ(o.rendezvous_file, "");
  EXPECT_EQ(o.token, "secret");
  EXPECT_TRUE(o.listens);
  EXPECT_EQ(o.timeout_s, 5.0);
  EXPECT_EQ(o.case_name, "bed");
  EXPECT_EQ(parse("every 1 checkpoint save/r.").checkpoint_prefix, "save/r.");
}

struct Bad {
  const char* line;
  const char* words;
};

TEST(CoupleBridgeOptions, WrongLinesAreRefused) {
  const Bad lines[] = {
      {"", "without every"},
      {"every 0", "every; given: 0"},
      {"every 1.5", "every; given: 1.5"},
      {"every", "every; given: nothing"},
      {"every 5 every 5", "twice"},
      {"every 5 transport tcp", "allowed: mpi | socket"},
      {"every 5 sizes big", "sizes; given: big; allowed: like | any"},
      {"every 5 timeout 0", "timeout; given: 0"},
      {"every 5 timeout soon", "timeout; given: soon"},
      {"every 5 evry 5", "keyword of fix couple/bridge; given: evry"},
      {"every 5 address host:9", "with transport mpi"},
      {"every 5 listen", "with transport mpi"},
      {"every 5 transport socket listen connect", "twice"},
      {"every 5 checkpoint r.*", "without * and %"},
  };
  for (const Bad& bad : lines) {
    try {
      parse(bad.line);
      ADD_FAILURE() << "accepted: " << bad.line;
    } catch (const InvalidInput& problem) {
      const std::string text = problem.what();
      EXPECT_NE(text.find(bad.words), std::string::npos) << text;
      for (const char* part : {"; given: ", "; allowed: ", "; to do: "}) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
      }
    }
  }
}

}  // namespace
}  // namespace powderlink::host
