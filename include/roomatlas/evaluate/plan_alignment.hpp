// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/pose2.hpp"
#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

enum class AlignedBy {
  nothing,         ///< there were no rooms to align: the identity
  trajectory,      ///< least squares over the robot's positions
  room_centroids,  ///< the centres of matched rooms, then their overlap
};

[[nodiscard]] const char* to_string(AlignedBy by);

struct PlanAlignment {
  Pose2 truth_from_building;
  AlignedBy by = AlignedBy::nothing;
  int rooms = 0;         ///< that it rests on, for room centroids
  double overlap = 0.0;  ///< sum of the paired rooms' IoU over the true rooms, on the lattice
};

struct PlanAlignOptions {
  double lattice_m = 0.1;     ///< of the overlaps; finer is slower and hardly better
  int start_rotations = 24;   ///< tried with both plans' centres on each other
  int anchor_rooms = 8;       ///< the largest rooms of the plan, each pair of which is tried ...
  double anchor_gap_m = 1.0;  ///< ... on each pair of true rooms as far apart to this
  double min_iou = 0.3;       ///< rooms that overlap less do not pull
  int max_rounds = 20;        ///< of matching and moving
};

/// The rigid motion that lays a plan on the true plan, found from the rooms' shapes alone, where
/// there is no true trajectory. Starts from several rotations and from pairs of rooms laid on pairs
/// of true rooms; from the starts that overlap best it matches rooms one to one and moves the
/// centres of matched rooms together by least squares, in turn, then moves and turns the whole in
/// small steps as long as the rooms overlap more, and keeps the best overlap.
/// Not guaranteed: a symmetric building can come out turned, and a plan that is bent or hardly
/// overlaps any room can come to lie anywhere.
[[nodiscard]] PlanAlignment align_plan(const FloorPlan& plan, const FloorPlan& truth,
                                       const PlanAlignOptions& options);

}  // namespace roomatlas
