// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/columns.hpp"

namespace roomatlas {

/// What may be a column.
struct Column {
  Point2 middle = Point2::Zero();
  double along_rad = 0.0;  ///< of a side
  double length_m = 0.0;   ///< along that; a round one's diameter
  double width_m = 0.0;
  bool is_round = false;
};

/// The pieces that are as thick as columns: those that were seen from all sides, then those that
/// were not and may be like one of them.
[[nodiscard]] std::vector<Column> column_candidates(const std::vector<PlanFurniture>& pieces,
                                                    const std::vector<SurfacePoint>& surfaces,
                                                    const ColumnOptions& options);

}  // namespace roomatlas
