// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "roomatlas/match/align.hpp"
#include "roomatlas/match/moving_points.hpp"
#include "roomatlas/match/recent_sweeps.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/odometry/lag_learner.hpp"
#include "roomatlas/odometry/noise.hpp"

namespace roomatlas {

struct LocalizeOptions {
  bool enabled = true;  ///< off: dead reckoning is believed inside a room, as in the paper
  double cell_m = 0.1;  ///< of the room's map; smaller cells need more sweeps to fill
  ScanOptions scan;
  AlignOptions align{.corner_weight = 0.0};  ///< corners would hold sweeps back in a corridor
  CorrelateOptions correlate;
  /// Between two readings, parts added up: odometry that lags reports a turn too late, hence so
  /// much of it. A position's 0.05 m lets corridors slip; 0.005 fails where odometry jumps.
  OdometryNoise odometry{.position = {.still = 0.02, .per_m = 0.1},
                         .heading = {.still = 0.02, .per_rad = 0.3}};
  double search_per_turn = 0.8;    ///< the heading is searched this share of the turn farther
  int max_points = 180;            ///< of a sweep that are aligned
  int min_matched = 20;            ///< fewer partners: odometry is believed
  double min_matched_share = 0.3;  ///< so is it below this share of the sweep
  double ease_share = 0.8;         ///< of the points on walls, with the pose this near to ...
  double ease_sigmas = 1.5;        ///< ... odometry's: no need to search. Smaller searches more
  double lost_share = 0.8;  ///< fewer of the points on walls: searched farther, since odometry
                            ///< may have slipped, or told a motion the wrong way round ...
  /// ... this far, plus twice the step
  CorrelateOptions lost{
      .reach_m = 0.2, .step_m = 0.1, .reach_rad = radians(16.0), .step_rad = radians(2.0)};
  double found_share = 0.65;      ///< so many on walls there, and ...
  double found_more_share = 0.1;  ///< ... so many more than before: it is believed
  double min_across = 60.0;       ///< points' weight on walls across the way, from which habits of
                                  ///< odometry's lengths are learnt
  double insert_every_m = 0.10;   ///< a sweep enters the map after this much motion ...
  double insert_every_deg = 4.0;  ///< ... or turn
  MovingPointsOptions moving;     ///< what moves neither holds the robot nor enters the map
  RecentSweepsOptions recent;     ///< of lasers with few beams, of which ...
  int min_matched_of_few = 6;     ///< ... so many partners suffice, and ...
  double min_across_of_few = 10.0;   ///< ... so much weight across: with 60 nothing is ever learnt
                                     ///< of lengths, and maps are as short as odometry, ...
  double insert_few_every_m = 0.03;  ///< ... each sweep enters the map sooner
  double insert_few_every_deg = 1.5;
};

/// True for a sensor whose single sweeps can be matched.
[[nodiscard]] bool can_be_matched(const RangeReading& reading);

/// What is learnt of odometry while the robot is found in one room after the other.
struct LearntOdometry {
  HabitLearner habits;
  LagLearner lag;
};
template <MaybeConst<LearntOdometry> Value, typename Visit>
void fields_of(Value& learnt, Visit& visit) {
  visit(learnt.habits, learnt.lag);
}

/// Finds the robot inside the room being mapped.
class Localizer {
 public:
  virtual ~Localizer() = default;
  /// Forgets the room.
  virtual void clear() = 0;
  /// Takes a reading at a known pose into its picture of the room.
  virtual void add(const RangeReading& reading, const Pose2& asr_from_robot) = 0;
  /// Where the robot is, and takes the reading into its picture of the room.
  /// @param predicted_asr_from_robot by odometry from the pose before
  /// @param step of odometry since the reading before, in the robot's frame
  [[nodiscard]] virtual Pose2 locate(const RangeReading& reading,
                                     const Pose2& predicted_asr_from_robot, const Pose2& step) = 0;
  /// Whether the poses that it gives for such readings fit the room's map.
  [[nodiscard]] virtual bool localizes(const RangeReading& reading) const = 0;
  /// What it learnt of odometry by the way; none where it did not match.
  [[nodiscard]] virtual std::optional<OdometryHabits> habits() const { return std::nullopt; }
  /// All that it keeps when it forgets a room; with it another goes on as this one would.
  [[nodiscard]] virtual LearntOdometry learnt() const { return {}; }
  virtual void resume(const LearntOdometry& /*learnt*/) {}
};

/// Finds the robot in the room's own map, sweep by sweep, so that odometry's drift does not smear
/// the walls. Remembers the room so far, and odometry's habits, which it takes out of each step;
/// cost and memory do not depend on the mission's length.
/// A laser of few beams takes the directions of walls from its last sweeps together.
/// Sweeps of sonars are too sparse to be matched one by one: they are neither matched nor added.
class RoomLocalizer : public Localizer {
 public:
  explicit RoomLocalizer(const LocalizeOptions& options)
      : options_(options), map_(options.cell_m), moving_(options.moving), recent_(options.recent) {}

  void clear() override;
  void add(const RangeReading& reading, const Pose2& asr_from_robot) override;
  [[nodiscard]] Pose2 locate(const RangeReading& reading, const Pose2& predicted_asr_from_robot,
                             const Pose2& step) override;
  [[nodiscard]] bool localizes(const RangeReading& reading) const override {
    return can_be_matched(reading);
  }
  [[nodiscard]] std::optional<OdometryHabits> habits() const override;
  [[nodiscard]] LearntOdometry learnt() const override { return learnt_; }
  void resume(const LearntOdometry& learnt) override { learnt_ = learnt; }

 private:
  /// Whether the robot has moved since the last sweep was added.
  [[nodiscard]] bool is_worth_adding(const Pose2& map_from_robot) const;
  void insert(const Scan& scan, const Pose2& map_from_robot);
  void insert_some_waiting();
  bool hide_moving(Scan& scan, const RangeReading& reading, const Pose2& map_from_robot);

  /// Where the points lie on the room's walls, near to where odometry has them if possible.
  [[nodiscard]] ScanAlignment match(const std::vector<ScanPoint>& points, const Pose2& predicted,
                                    const Pose2& step) const;
  [[nodiscard]] ScanAlignment search_wide(const std::vector<ScanPoint>& points,
                                          const Pose2& predicted, double step_m,
                                          double turned_rad) const;
  [[nodiscard]] int min_matched() const {
    return has_few_ ? options_.min_matched_of_few : options_.min_matched;
  }
  [[nodiscard]] bool is_length_seen(const ScanAlignment& aligned) const;
  [[nodiscard]] bool is_at_ease(const ScanAlignment& aligned, const PosePrior& prior) const;

  LocalizeOptions options_;
  LocalMap map_;
  MovingPoints moving_;
  std::deque<std::pair<RangeReading, Pose2>> before_;  ///< the last at the door, for `moving_`
  RecentSweeps recent_;                                ///< of a laser with few beams
  bool has_few_ = false;                               ///< the sweep at hand is one of few beams
  LearntOdometry learnt_;
  std::vector<std::pair<RangeReading, Pose2>> waiting_;  ///< to be drawn, the newest first: a new
                                                         ///< room begins with many at once
  std::optional<Pose2> last_added_;
  double recent_turn_rad_ = 0.0;  ///< fading: odometry that lags reports a turn too late
};

/// True when a sweep at `to` shows the room from elsewhere than one at `from`.
/// @param has_few_beams see `RecentSweeps::are_needed`
[[nodiscard]] bool is_new_view(const Pose2& from, const Pose2& to, const LocalizeOptions& options,
                               bool has_few_beams = false);

}  // namespace roomatlas
