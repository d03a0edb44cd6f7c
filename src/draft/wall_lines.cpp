// SPDX-License-Identifier: GPL-3.0-or-later
#include "wall_lines.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kSameLine_m = 0.08;    // faces this near are on one line
constexpr double kParallelSine = 0.03;  // and turn by less
constexpr double kNextFace_m = 4.0;     // along it; larger joins walls of different rooms

}  // namespace

std::vector<Interval> on_line(const WallFace& face, const std::vector<WallFace>& faces,
                              double min_face_m) {
  std::vector<Interval> stretches;
  for (const WallFace& other : faces) {
    if (std::abs(std::sin(other.normal_rad - face.normal_rad)) >= kParallelSine) continue;
    if (other.is_furniture || other.support_m() < min_face_m) continue;
    const Point2 middle = (other.at(other.low_m()) + other.at(other.high_m())) / 2.0;
    if (std::abs(middle.dot(face.normal()) - face.offset_m) >= kSameLine_m) continue;
    for (const Interval& seen : other.seen) {
      const double a = other.at(seen.low_m).dot(face.along());
      const double b = other.at(seen.high_m).dot(face.along());
      stretches.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(stretches.begin(), stretches.end(),
            [](const Interval& a, const Interval& b) { return a.low_m < b.low_m; });
  return stretches;
}

double line_support_m(const WallFace& face, const std::vector<WallFace>& faces) {
  double support_m = 0.0;
  double group_m = 0.0;
  double end_m = -1e9;
  bool is_own = false;
  for (const Interval& one : on_line(face, faces, 0.0)) {
    if (one.low_m > end_m + kNextFace_m) {
      if (is_own) support_m = std::max(support_m, group_m);
      group_m = 0.0;
      is_own = false;
    }
    group_m += std::max(0.0, one.high_m - std::max(one.low_m, end_m));
    end_m = std::max(end_m, one.high_m);
    is_own = is_own || (one.low_m <= face.high_m() && one.high_m >= face.low_m());
  }
  return is_own ? std::max(support_m, group_m) : support_m;
}

double seen_on_line_m(const WallFace& face, const std::vector<WallFace>& faces, double within_m) {
  double sum_m = 0.0;
  for (const WallFace& other : faces) {
    if (other.is_furniture) continue;
    if (std::abs(std::sin(other.normal_rad - face.normal_rad)) >= kParallelSine) continue;
    const Point2 middle = other.at((other.low_m() + other.high_m()) / 2.0);
    if (std::abs(middle.dot(face.normal()) - face.offset_m) < within_m) sum_m += other.support_m();
  }
  return sum_m;
}

bool goes_on_at(const WallFace& wall, const Point2& at, double past_m) {
  const double along_m = at.dot(wall.along());
  return std::any_of(wall.cover.begin(), wall.cover.end(), [&](const Interval& one) {
    return along_m > one.low_m - past_m && along_m < one.high_m + past_m;
  });
}

std::optional<double> crossing_m(const WallFace& face, double from_m, double sign,
                                 const WallFace& wall, double least_sine) {
  const double sine = wall.normal().dot(face.along());
  if (std::abs(sine) < least_sine) return std::nullopt;
  return sign * (wall.offset_m - face.at(from_m).dot(wall.normal())) / sine;
}

void mark(const WallFace& face, const Interval& stretch, const CellFrame& frame, CellMask& mask) {
  for_each_cell_on_line(frame.cell_of(face.at(stretch.low_m)),
                        frame.cell_of(face.at(stretch.high_m)), [&](const Cell& cell) {
                          mask.set(cell, true);
                          return true;
                        });
}

}  // namespace roomatlas
