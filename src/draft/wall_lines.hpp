// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "roomatlas/draft/occupancy.hpp"
#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// What was seen of walls on a face's line, whichever way they look: stretches along the face,
/// ascending; those of one face do not overlap, those of two may.
/// @param min_face_m faces with less support do not count
[[nodiscard]] std::vector<Interval> on_line(const WallFace& face,
                                            const std::vector<WallFace>& faces, double min_face_m);

/// How much wall was seen on a face's line, up to gaps of 4 m: what is farther is another wall's.
[[nodiscard]] double line_support_m(const WallFace& face, const std::vector<WallFace>& faces);

/// The same however far apart, which lie within a distance of the line.
[[nodiscard]] double seen_on_line_m(const WallFace& face, const std::vector<WallFace>& faces,
                                    double within_m);

/// Whether a wall goes on beside a place, seen or hidden, or ends no farther than that from it.
[[nodiscard]] bool goes_on_at(const WallFace& wall, const Point2& at, double past_m);

/// How far beyond a place on a face, the way that `sign` says, its line meets that of a wall;
/// negative before it.
/// @returns nothing where the lines cross at less than that sine
[[nodiscard]] std::optional<double> crossing_m(const WallFace& face, double from_m, double sign,
                                               const WallFace& wall, double least_sine);

/// Sets the cells along a stretch of a face.
void mark(const WallFace& face, const Interval& stretch, const CellFrame& frame, CellMask& mask);

/// The parts of a stretch that are kept, longer than `least_m`, asked each `apart_m`.
/// @param keeps of a position along the face
template <typename Keeps>
[[nodiscard]] std::vector<Interval> kept_parts(const Interval& stretch, double apart_m,
                                               double least_m, Keeps keeps) {
  std::vector<Interval> kept;
  Interval part{stretch.low_m, stretch.low_m};
  const auto end_part = [&] {
    if (part.length_m() > least_m) kept.push_back(part);
  };
  for (double at_m = stretch.low_m; at_m < stretch.high_m + apart_m; at_m += apart_m) {
    const double along_m = std::min(at_m, stretch.high_m);
    if (keeps(along_m)) {
      part.high_m = along_m;
    } else {
      end_part();
      part = {along_m, along_m};
    }
  }
  end_part();
  return kept;
}

}  // namespace roomatlas
