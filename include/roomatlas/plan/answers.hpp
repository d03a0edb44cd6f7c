// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas {

/// Solutions that explain a mission's readings about equally well, the best first.
struct Answers {
  int drawn = 1;              ///< which of them this is, from 1
  int count = 1;              ///< how many there are
  double first_score = 0.0;   ///< metres of wall that speak for the first ...
  double second_score = 0.0;  ///< ... and for the second, where there is one
  std::string second;         ///< what is otherwise in it
};

/// "a second answer explains the readings nearly as well (412 m of wall against 420 m): ...", or
/// "alternative 2 of 2 ..."; empty where there is but one. Without a full stop.
[[nodiscard]] std::string words(const Answers& answers);

}  // namespace roomatlas
