// SPDX-License-Identifier: GPL-3.0-or-later
/// \file refuses.h
/// Holds the house rule for errors: what failed; what was given; what is allowed; what to do.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/invalid_input.h"

namespace powderlink::test {

/// The text between two marks, empty when one of them is missing.
inline std::string between(const std::string& text, const std::string& from,
                           const std::string& to) {
  const auto begin = text.find(from);
  if (begin == std::string::npos) return {};
  const auto start = begin + from.size();
  const auto end = to.empty() ? text.size() : text.find(to, start);
  return end == std::string::npos ? std::string{} : text.substr(start, end - start);
}

/// True when the action throws InvalidInput with four parts, of which the first contains `what` and
/// the second contains `given`.
template <class Action>
::testing::AssertionResult refuses(Action&& action, const std::string& what,
                                   const std::string& given = {}) {
  std::string text;
  try {
    action();
    return ::testing::AssertionFailure() << "accepted; expected an error on '" << what << "'";
  } catch (const InvalidInput& e) {
    text = e.what();
  } catch (const std::exception& e) {
    return ::testing::AssertionFailure() << "another exception: " << e.what();
  }
  const std::vector<std::string> parts = {
      between(text, "", "; given: "), between(text, "; given: ", "; allowed: "),
      between(text, "; allowed: ", "; to do: "), between(text, "; to do: ", "")};
  for (const std::string& part : parts) {
    if (part.empty()) return ::testing::AssertionFailure() << "a part is empty: " << text;
  }
  if (parts[0].find(what) == std::string::npos) {
    return ::testing::AssertionFailure() << "does not name '" << what << "': " << text;
  }
  if (parts[1].find(given) == std::string::npos) {
    return ::testing::AssertionFailure() << "does not repeat '" << given << "': " << text;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace powderlink::test
