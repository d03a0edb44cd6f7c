// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace roomatlas::bench {

/// What one plan scores. NaN: not judged, because the truth shows none of it.
struct PlanScore {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double rooms = kNone;
  double true_rooms = kNone;
  double rooms_f1 = kNone;         ///< at IoU .5
  double strict_rooms_f1 = kNone;  ///< at IoU .75
  double mean_true_iou = kNone;    ///< over all true rooms
  double corners_f1 = kNone;       ///< within .3 m
  double walls_m = kNone;          ///< median distance from the plan's walls to true ones
  double area_error = kNone;       ///< mean over matched rooms, a share
  double doors_f1 = kNone;
  double door_width_m = kNone;     ///< mean error over matched doors
  double edits = kNone;            ///< of the graph: missing, extra and wrong edges
  double vertices_a_room = kNone;  ///< mean
  double true_vertices_a_room = kNone;
  double assemble_s = kNone;  ///< processor time
};

struct PlanRow {
  std::string group;
  std::string name;
  PlanScore score;
  std::string failure;  ///< why there is no plan; empty where there is one
};

/// The row's line of the table.
[[nodiscard]] std::string plan_line(const PlanRow& row);

/// Markdown: a line for each row, and for each group of more than one its means over what was
/// judged. A case without a plan counts there with no room found.
[[nodiscard]] std::string plan_table(const std::vector<PlanRow>& rows);

}  // namespace roomatlas::bench
