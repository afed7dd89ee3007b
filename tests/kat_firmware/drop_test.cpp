// SPDX-License-Identifier: GPL-3.0-or-later
#include "kat_firmware/core/kat_drop.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace kat {
namespace {

Drop some_drop() {
  Drop d;
  d.number = 7;
  d.state = State::report;
  d.carrier_um = 10000;
  d.beam_um = 30000;
  d.latency_us = 66;
  d.enter_us = 190000;
  d.leave_us = 195000;
  d.touch_us = 206000;
  d.velocity_um_s = 1980000;
  d.switches = 3;
  d.contacts.edge(true, 206000, 5);
  d.contacts.edge(false, 206101, 5);
  d.contacts.edge(true, 250000, 5);
  return d;
}

std::vector<std::string> texts(const Drop& d) {
  std::vector<std::string> lines;
  for (uint8_t i = 0; i < d.lines(); ++i) {
    LineWriter writer = drop_line(d, i);
    EXPECT_TRUE(writer.fits());
    const std::string text = writer.finish();
    lines.push_back(text.substr(0, text.size() - 1));
  }
  return lines;
}

using Result = DropReader::Result;

Result take(DropReader& reader, const std::string& text) {
  Line line;
  EXPECT_EQ(line.parse(text.data(), static_cast<uint16_t>(text.size())), Code::none) << text;
  return reader.take(line);
}

Result take_words(DropReader& reader, const char* word,
                  const std::vector<std::pair<const char*, const char*>>& fields) {
  LineWriter writer(word);
  for (const auto& field : fields) writer.text(field.first, field.second);
  const std::string text = writer.finish();
  return take(reader, text.substr(0, text.size() - 1));
}

TEST(Drop, IsReadAsItWasWritten) {
  const Drop d = some_drop();
  const auto lines = texts(d);
  ASSERT_EQ(lines.size(), 7U);
  DropReader reader;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(take(reader, lines[i]), i + 1 < lines.size() ? Result::more : Result::whole);
    EXPECT_EQ(reader.inside(), i + 1 < lines.size());
  }
  EXPECT_EQ(texts(reader.drop()), lines);
  EXPECT_EQ(reader.drop().vibration_us, static_cast<uint32_t>(kNoValue));
  EXPECT_EQ(reader.drop().contacts[1].duration_us, static_cast<uint32_t>(kNoValue));
  EXPECT_EQ(reader.drop().contacts.finished(), 1U);
}

TEST(Drop, EveryLineFitsWithTheLargestValues) {
  Drop d;
  d.fault = Code::contact_out_of_order;
  d.state = State::contact_ended;
  const uint32_t largest = 4294967294U;
  d.number = d.carrier_um = d.beam_um = d.latency_us = d.enter_us = d.leave_us = largest;
  d.touch_us = d.vibration_us = d.velocity_um_s = d.switches = d.peak_mg = largest;
  for (int i = 0; i < 20; ++i) {
    d.contacts.edge(true, largest, 0);
    d.contacts.edge(false, largest - 1, 0);
  }
  EXPECT_EQ(texts(d).size(), 5U + kContactLimit);
}

TEST(Drop, ALostRepeatedOrSwappedLineBreaksIt) {
  const auto lines = texts(some_drop());
  const auto whole = [&](const std::vector<std::string>& some) {
    DropReader reader;
    for (const auto& text : some) {
      if (take(reader, text) == Result::whole) return true;
    }
    return false;
  };
  EXPECT_TRUE(whole(lines));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto lost = lines;
    lost.erase(lost.begin() + static_cast<long>(i));
    EXPECT_FALSE(whole(lost)) << i;
    if (i > 0 && i + 1 < lines.size()) {
      auto twice = lines;
      twice.insert(twice.begin() + static_cast<long>(i), lines[i]);
      EXPECT_FALSE(whole(twice)) << i;
    }
    if (i + 1 < lines.size()) {
      auto swapped = lines;
      std::swap(swapped[i], swapped[i + 1]);
      EXPECT_FALSE(whole(swapped)) << i;
    }
  }
  // A new beginning is not held against the old one.
  auto again = lines;
  again.insert(again.begin(), lines.begin(), lines.begin() + 3);
  EXPECT_TRUE(whole(again));
}

TEST(Drop, FieldsThatAreMissingOrWrongBreakIt) {
  DropReader reader;
  EXPECT_EQ(take_words(reader, "status", {{"n", "1"}}), Result::other);
  EXPECT_EQ(take_words(reader, "drop", {{"fault", "none"}, {"state", "idle"}}), Result::broken);
  EXPECT_EQ(take_words(reader, "drop", {{"n", "1"}, {"state", "idle"}}), Result::broken);
  EXPECT_EQ(take_words(reader, "drop", {{"n", "1"}, {"fault", "none"}}), Result::broken);
  EXPECT_EQ(take_words(reader, "drop", {{"n", "1"}, {"fault", "odd"}, {"state", "idle"}}),
            Result::broken);
  EXPECT_EQ(take_words(reader, "drop", {{"n", "1"}, {"fault", "none"}, {"state", "odd"}}),
            Result::broken);
  const auto after = [&](std::size_t count, const char* word,
                         const std::vector<std::pair<const char*, const char*>>& fields) {
    const auto lines = texts(some_drop());
    DropReader fresh;
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(take(fresh, lines[i]), Result::more);
    return take_words(fresh, word, fields);
  };
  EXPECT_EQ(after(1, "geometry", {{"n", "8"}}), Result::broken);
  EXPECT_EQ(after(1, "geometry", {{"n", "7"}, {"carrier_um", "1"}}), Result::broken);
  const std::pair<const char*, const char*> n{"n", "7"}, i{"i", "1"}, start{"start_us", "1"},
      duration{"duration_us", "1"}, chatter{"chatter", "0"};
  EXPECT_EQ(after(4, "contact", {n, i, start, duration, chatter}), Result::more);
  EXPECT_EQ(after(4, "contact", {n, start, duration, chatter}), Result::broken);
  EXPECT_EQ(after(4, "contact", {n, i, duration, chatter}), Result::broken);
  EXPECT_EQ(after(4, "contact", {n, i, start, chatter}), Result::broken);
  EXPECT_EQ(after(4, "contact", {n, i, start, duration}), Result::broken);
  EXPECT_EQ(after(5, "contact", {n, i, start, duration, chatter}), Result::broken);
  const std::pair<const char*, const char*> total{"contacts", "2"}, finished{"finished", "1"},
      lines{"lines", "6"};
  EXPECT_EQ(after(6, "end", {n, total, finished, lines}), Result::whole);
  EXPECT_EQ(after(6, "end", {n, finished, lines}), Result::broken);
  EXPECT_EQ(after(6, "end", {n, total, lines}), Result::broken);
  EXPECT_EQ(after(6, "end", {n, total, finished}), Result::broken);
  EXPECT_EQ(after(6, "end", {n, {"contacts", "1"}, finished, lines}), Result::broken);
  EXPECT_EQ(after(6, "end", {n, total, {"finished", "3"}, lines}), Result::broken);
}

TEST(Drop, MoreContactsThanThereIsRoomForBreakIt) {
  Drop d = some_drop();
  for (uint32_t i = 0; i < 2U * kContactLimit; ++i) {
    d.contacts.edge(i % 2 != 0, 300000 + 1000 * i, 0);
  }
  DropReader reader;
  const auto lines = texts(d);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    EXPECT_EQ(take(reader, lines[i]), Result::more);
  EXPECT_EQ(
      take_words(
          reader, "contact",
          {{"n", "7"}, {"i", "13"}, {"start_us", "1"}, {"duration_us", "1"}, {"chatter", "0"}}),
      Result::broken);
}

}  // namespace
}  // namespace kat
