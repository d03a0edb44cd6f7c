// SPDX-License-Identifier: GPL-3.0-or-later
#include "passage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace roomatlas {
namespace {

constexpr double kFromM = 0.5;     // nearer lies the wall itself
constexpr double kToM = 2.5;       // farther begins what is behind the room
constexpr double kQuantile = 0.3;  // of the widths: a corridor is wider at doors beside the cut
constexpr double kBetweenM = 0.1;  // lines along which the width is measured
constexpr double kStepM = 0.05;    // along such a line
constexpr double kMost = 1.2;      // logarithm; wider is as good

/// The open part of a line through a point.
double open_width_m(const OpenFloor& floor, const Point2& middle, const Point2& along,
                    double most_m) {
  double width_m = kStepM;
  for (const double sign : {-1.0, 1.0}) {
    for (double off_m = kStepM; off_m < most_m; off_m += kStepM) {
      if (!floor.is_open(middle + sign * off_m * along)) break;
      width_m += kStepM;
    }
  }
  return width_m;
}

double widening_on(const OpenFloor& floor, const Segment2& jambs, const Point2& across) {
  const Point2 middle = (jambs.a + jambs.b) / 2.0;
  const double opening_m = (jambs.b - jambs.a).norm();
  const Point2 along = (jambs.b - jambs.a) / opening_m;
  const double most_m = opening_m / 2.0 * std::exp(kMost) + kStepM;
  std::vector<double> widths_m;
  for (double off_m = kBetweenM; off_m < kToM; off_m += kBetweenM) {
    const Point2 at = middle + off_m * across;
    if (!floor.is_open(at)) break;
    if (off_m > kFromM - kBetweenM / 2.0) {
      widths_m.push_back(open_width_m(floor, at, along, most_m));
    }
  }
  if (widths_m.empty()) return 0.0;
  const auto half = widths_m.begin() + static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(widths_m.size()));
  std::nth_element(widths_m.begin(), half, widths_m.end());
  return std::clamp(std::log(*half / opening_m), 0.0, kMost);
}

}  // namespace

Widening widening(const OpenFloor& floor, const Segment2& jambs) {
  const Point2 way = jambs.b - jambs.a;
  if (way.norm() < floor.frame.cell_m) return {kMost, kMost};
  const Point2 across = Point2(-way.y(), way.x()).normalized();
  const double left = widening_on(floor, jambs, across);
  const double right = widening_on(floor, jambs, -across);
  return {std::min(left, right), std::max(left, right)};
}

}  // namespace roomatlas
