// SPDX-License-Identifier: GPL-3.0-or-later
/// \file bridge_error.h
/// The one exception of the bridge. Its text has the four parts of every message of this project:
/// what failed; given; allowed; to do.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace powderlink::bridge {

class BridgeError : public std::runtime_error {
 public:
  enum class Kind {
    bad_input,      ///< an argument or option of this program
    bad_frame,      ///< bytes that are not a whole, unharmed frame
    wrong_version,  ///< a frame of another protocol version
    timeout,        ///< nothing came before the deadline
    peer_lost,      ///< the other program closed the connection or died
    refused,        ///< the other program does not want this connection
    mismatch,       ///< both programs run, but not the same case, fields or step
    peer_failed     ///< the other program reported an error of its own
  };

  /// \param what_failed  the step or quantity, e.g. "frame: checksum"
  /// \param given        what was found
  /// \param allowed      range or list of valid values
  /// \param to_do        the next thing to do
  BridgeError(Kind kind, std::string_view what_failed, std::string_view given,
              std::string_view allowed, std::string_view to_do)
      : std::runtime_error(std::string(what_failed) + "; given: " + std::string(given) +
                           "; allowed: " + std::string(allowed) + "; to do: " + std::string(to_do)),
        kind_(kind) {}

  /// With a text that already has the four parts, e.g. from another rank.
  BridgeError(Kind kind, const std::string& text) : std::runtime_error(text), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace powderlink::bridge
