// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/learnt_sum.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace roomatlas {
namespace {

constexpr double kMostDeviations = 3.0;  // beyond it nothing was learnt

}  // namespace

double part_of(const LearntTerm& term, const std::vector<JudgedFigure>& figures) {
  const auto figure = std::find_if(figures.begin(), figures.end(),
                                   [&](const JudgedFigure& one) { return one.name == term.name; });
  if (figure == figures.end()) {
    throw std::logic_error(std::string("no figure is called ") + term.name);
  }
  const double off = (figure->value - term.mean) / term.deviation;
  return term.weight * std::clamp(off, -kMostDeviations, kMostDeviations);
}

double sum_of(const LearntSum& sum, const std::vector<JudgedFigure>& figures) {
  double value = sum.bias;
  for (const LearntTerm& term : sum.terms) value += part_of(term, figures);
  return value;
}

}  // namespace roomatlas
