// SPDX-License-Identifier: GPL-3.0-or-later
/// \file fails.h
/// Holds the house rule for errors of the bridge: the right kind, four parts, the right words.
#pragma once

#include <string>

#include "coupling/bridge/bridge_error.h"

namespace powderlink::test {

/// Empty when the action throws a BridgeError of that kind with four parts and `words` in it;
/// otherwise what is wrong.
template <class Action>
std::string failure_of(Action&& action, bridge::BridgeError::Kind kind, const std::string& words) {
  std::string text;
  try {
    action();
    return "accepted; expected an error with '" + words + "'";
  } catch (const bridge::BridgeError& e) {
    text = e.what();
    if (e.kind() != kind) return "another kind of error: " + text;
  } catch (const std::exception& e) {
    return std::string("another exception: ") + e.what();
  }
  std::size_t from = 0;
  for (const char* part : {"; given: ", "; allowed: ", "; to do: "}) {
    const auto at = text.find(part, from);
    if (at == std::string::npos || at == from) return "a part is missing: " + text;
    from = at + std::string(part).size();
  }
  if (from == text.size()) return "nothing to do: " + text;
  if (text.find(words) == std::string::npos) return "does not say '" + words + "': " + text;
  return {};
}

}  // namespace powderlink::test
