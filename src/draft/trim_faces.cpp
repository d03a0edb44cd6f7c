// SPDX-License-Identifier: GPL-3.0-or-later
#include "trim_faces.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kReach_m = 0.5;      // a cone is no wider where edges are heard
constexpr double kSquareSine = 0.95;  // of the angle between faces
constexpr double kPast_m = 0.1;       // beyond the ends of the face that cuts
constexpr double kLeastLeft_m = 0.15;
constexpr double kFewEchoes = 0.2;  // mean reflected share beyond
constexpr double kTrimStep_m = 0.05;

/// The mean over places of the largest reflected share around them.
double reflected_along(const ReflectionMap& counts, const WallFace& face, const Interval& stretch) {
  if (stretch.length_m() <= 0.0) return 0.0;
  const int places = std::max(2, static_cast<int>(stretch.length_m() / kTrimStep_m));
  double sum = 0.0;
  for (int i = 0; i < places; ++i) {
    const Cell at =
        counts.frame().cell_of(face.at(stretch.low_m + stretch.length_m() * i / (places - 1)));
    double most = 0.0;
    for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& cell) {
      most = std::max(most, counts.at(cell).reflected_share());
    });
    sum += most;
  }
  return sum / places;
}

}  // namespace

void trim_at_corners(const ReflectionMap& counts, std::vector<WallFace>& faces) {
  const std::vector<WallFace> before = faces;
  for (WallFace& face : faces) {
    for (Interval& seen : face.seen) {
      for (const WallFace& other : before) {
        const double sine = face.along().dot(other.normal());
        if (std::abs(sine) < kSquareSine) continue;
        const double at_m = (other.offset_m - face.at(0.0).dot(other.normal())) / sine;
        const double on_other_m = face.at(at_m).dot(other.along());
        if (on_other_m < other.low_m() - kPast_m || on_other_m > other.high_m() + kPast_m) continue;
        const bool ends_high = sine > 0.0 && at_m >= seen.high_m - kReach_m && at_m < seen.high_m &&
                               at_m > seen.low_m + kLeastLeft_m;
        const bool ends_low = sine < 0.0 && at_m <= seen.low_m + kReach_m && at_m > seen.low_m &&
                              at_m < seen.high_m - kLeastLeft_m;
        if (ends_high &&
            reflected_along(counts, face, {at_m + kPast_m, seen.high_m}) < kFewEchoes) {
          seen.high_m = at_m;
        }
        if (ends_low && reflected_along(counts, face, {seen.low_m, at_m - kPast_m}) < kFewEchoes) {
          seen.low_m = at_m;
        }
      }
    }
  }
}

}  // namespace roomatlas
