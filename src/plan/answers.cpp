// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/answers.hpp"

#include <cmath>

namespace roomatlas {

std::string words(const Answers& answers) {
  if (answers.count < 2) return "";
  const auto metres = [](double score) { return std::to_string(std::lround(score)) + " m"; };
  const std::string first = metres(answers.first_score);
  const std::string second = metres(answers.second_score);
  if (answers.drawn == 1) {
    return "a second answer explains the readings nearly as well (" + second +
           " of wall speak for it against " + first + "): " + answers.second;
  }
  return "this is alternative " + std::to_string(answers.drawn) + " of " +
         std::to_string(answers.count) + " (" + second + " of wall speak for it, " + first +
         " for the first): " + answers.second;
}

}  // namespace roomatlas
