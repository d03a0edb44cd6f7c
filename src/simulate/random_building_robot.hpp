// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "odometer.hpp"
#include "random_building_visit.hpp"
#include "roomatlas/asr/store.hpp"
#include "roomatlas/simulate/random_building.hpp"

#include <optional>
#include <vector>

namespace roomatlas::random_building_layout {

/// Drives from space to space and hands over an ASR for each visit. Spaces must live until they
/// are left.
class RandomBuildingRobot {
 public:
  RandomBuildingRobot(const RandomBuildingOptions& options, AsrSink& sink,
                      const std::function<void(const TrueVisit&)>& truth, const Space& start,
                      const Pose2& world_from_start);

  /// Straight to a place in the space. Long ways are cut at open passages.
  void go_to(const Point2& point);
  /// Through a door of the space into the next one, to just behind the door.
  void cross(const LaidOpening& opening, const Space& next);
  void finish();

  [[nodiscard]] Point2 position() const { return world_from_robot_.position(); }
  [[nodiscard]] const Space& space() const { return *space_; }
  [[nodiscard]] const RandomBuildingSummary& summary() const { return summary_; }

 private:
  void turn_to(double heading_rad);
  void advance(double length_m);
  void forward(double length_m, bool may_cut);
  void sample();
  void leave(Exit exit, const Space& next, const Pose2& world_from_pivot);
  void close(const std::optional<Exit>& exit);
  [[nodiscard]] Exit seen_doorway(double width_m);
  [[nodiscard]] Pose2 asr_from_robot() const;

  const RandomBuildingOptions& options_;
  AsrSink& sink_;
  const std::function<void(const TrueVisit&)>& truth_;
  Odometer odometer_;
  RandomStream vertex_noise_;
  RandomStream jamb_noise_;
  RandomBuildingSummary summary_;

  const Space* space_;
  Pose2 world_from_robot_;
  double time_s_;
  Pose2 odom_from_asr_;
  Pose2 world_from_asr_;
  std::optional<Exit> entry_;
  std::vector<UsedDoorway> used_;
  std::vector<PathSample> path_;
  std::vector<Pose2> world_from_path_;  ///< parallel to `path_`
  double visit_m_ = 0.0;                ///< driven in the ASR
};

}  // namespace roomatlas::random_building_layout
