// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correction.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas::bench {

/// Where a label picture lies in a building: turned by half a turn or not at all, stretched along
/// its own axes, turned a little more, and moved.
struct LabelAlignment {
  Point2 picture_middle_px = Point2::Zero();
  bool is_half_turned = false;
  double x_m = 0.0;  ///< of the picture's middle, in the building
  double y_m = 0.0;
  double pixel_x_m = 0.0;
  double pixel_y_m = 0.0;
  double angle_rad = 0.0;
  double mean_distance_m = 0.0;  ///< of the labels' borders to what was hit, each at most 0.4 m

  [[nodiscard]] Point2 building_from_picture(const Point2& point_px) const;
};

/// Lays the borders of labelled rooms on the cells where a mission's beams ended: every start of
/// a coarse grid, then the best of them in steps that are halved. Looks at readings alone, at no
/// plan, so that it is the same for all plans of one correction.
/// @param labels its coordinates are pixels, y up
/// @throws InputError for a mission without readings
[[nodiscard]] LabelAlignment fit_labels(const FloorPlan& labels, const AsrSource& mission,
                                        const Correction& correction);

/// The labelled rooms in building metres.
[[nodiscard]] FloorPlan laid(const LabelAlignment& alignment, FloorPlan labels);

}  // namespace roomatlas::bench
