// SPDX-License-Identifier: GPL-3.0-or-later
/// \file argument_words.h
/// The words of a fix command, read one after the other; every error names the keyword.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <boost/lexical_cast.hpp>

#include "base/invalid_input.h"

namespace powderlink::host {

class Words {
 public:
  /// \param narg, arg  as LIGGGHTS hands them to a fix: id, group and style come first
  Words(int narg, const char* const* arg) : n_(narg), arg_(arg) {}
  bool more() const { return i_ < n_; }
  std::string next(const std::string& what, const std::string& allowed) {
    if (!more())
      throw InvalidInput(what, "nothing (end of the line)", allowed, "complete the line");
    return arg_[i_++];
  }
  double number(const std::string& what, double low, double high, const std::string& allowed) {
    const std::string word = next(what, allowed);
    double value = 0.0;
    if (!boost::conversion::try_lexical_convert(word, value) || !(value >= low && value <= high)) {
      throw InvalidInput(what, word, allowed, "give one number in SI units");
    }
    return value;
  }
  double positive(const std::string& what) {
    return number(what, std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                  "> 0");
  }
  int count(const std::string& what, int low) {
    const std::string allowed = "a whole number from " + std::to_string(low) + " to 10000000";
    const int before = i_;
    const double value = number(what, low, 1e7, allowed);
    if (value != std::floor(value)) {
      throw InvalidInput(what, arg_[before], allowed, "give a number without a fraction");
    }
    return static_cast<int>(value);
  }

 private:
  int n_;
  const char* const* arg_;
  int i_ = 3;
};

}  // namespace powderlink::host
