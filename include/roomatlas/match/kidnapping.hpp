// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// The robot was carried away: two readings that follow each other cannot be one course.
struct Kidnapping {
  std::int64_t reading = 0;  ///< number of the first one after it, from 0
  double before_s = 0.0;     ///< time of the last reading before it ...
  double after_s = 0.0;      ///< ... and of the first one after it
  double agreement = 0.0;    ///< of the best of all pairs of sweeps across it, [0, 1]
};

struct KidnappingOptions {
  bool enabled = true;          ///< off: a mission is one course
  int sweeps = 3;               ///< on either side that are compared, each with each; 1 to 8
  double apart_s = 0.1;         ///< sweeps that follow sooner are passed over
  double suspect_share = 0.75;  ///< of what can be compared agrees, where odometry has it: less is
                                ///< looked at closely
  double course_share = 0.75;   ///< of two sweeps on one side agrees at least: a course
  double broken_share = 0.7;    ///< of both sides agrees at most, wherever in reach; recorded
                                ///< courses have 0.80 at least
  int least_points = 120;  ///< of both sweeps together: of fewer, noise and odometry's lag make so
                           ///< many disagree that courses are cut
  double comparable_share = 0.4;  ///< of the points can be compared, or nothing is said
  double reach_m = 0.5;           ///< odometry may have slipped by so much ...
  double reach_m_per_s = 0.5;     ///< ... and so much for each second between
  double most_reach_m = 1.5;
  double reach_rad = radians(30.0);
};

/// Finds where the robot was carried, from what its lasers saw. Each sweep is laid on the one
/// before where odometry has it. Where less of the two agrees than on a course, the sweeps before
/// and after are laid on each other wherever a slip could have taken the robot: it was carried if
/// none fits, while those before fit each other where odometry has them, and those after too. The
/// share that agrees is of what both could see: a point behind what the other sweep saw says
/// nothing, one before it contradicts. Says nothing of a robot that was carried to where it looks
/// alike, nor of sweeps that see too little in common: a kidnapping that is missed costs less than
/// a course that is cut. Sonars are passed over. Memory does not grow with the mission.
class KidnappingFinder {
 public:
  explicit KidnappingFinder(const KidnappingOptions& options);
  ~KidnappingFinder();
  KidnappingFinder(const KidnappingFinder&) = delete;
  KidnappingFinder& operator=(const KidnappingFinder&) = delete;

  /// Takes the next reading.
  void add(const RangeReading& reading);
  /// Those found so far, in order; one is known some sweeps after it.
  [[nodiscard]] const std::vector<Kidnapping>& found() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of a whole mission, from where it is.
[[nodiscard]] std::vector<Kidnapping> find_kidnappings(MissionSource& mission,
                                                       const KidnappingOptions& options);

}  // namespace roomatlas
