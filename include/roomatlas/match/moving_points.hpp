// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "roomatlas/match/scan.hpp"

namespace roomatlas {

/// Measured on simulated missions with people (docs/evaluation.md, People).
struct MovingPointsOptions {
  double apart_s = 0.2;           ///< between the sweeps that are remembered ...
  int kept = 6;                   ///< ... so many of them
  double tolerance_m = 0.07;      ///< of a place: larger overlooks people who walk slowly
  double tolerance_share = 0.02;  ///< ... and of its range: headings are a degree wrong
  int min_sweeps = 2;             ///< so many must tell that a point moves, and ...
  double most_there = 0.5;        ///< ... at most this share of them may have seen it there before
  int min_points = 3;             ///< of a thing: a chair's leg lies between two beams at times
  double gap_m = 0.5;             ///< between neighbouring points of one thing
  double widest_m = 1.0;          ///< of a thing that moves: what is wider is a wall
  double slip_m = 0.2;            ///< farther off odometry no person holds: wheels slipped
  double most_share = 0.5;        ///< of a sweep: if more moves, the step is wrong
};

/// Finds what moves in a laser's sweeps, people above all: points where the sweeps of the last
/// second looked through, or where something stood before them that is gone. In a corridor a
/// person who walks ahead is often all that tells how far the robot went, and tells it wrong.
class MovingPoints {
 public:
  explicit MovingPoints(const MovingPointsOptions& options);
  ~MovingPoints();
  MovingPoints(MovingPoints&&) noexcept;
  MovingPoints& operator=(MovingPoints&&) noexcept;

  /// Forgets the sweeps.
  void clear();
  /// Makes points that move free space that was seen up to there, and remembers the whole sweep.
  /// How far the robot went since the sweep before is told by odometry: matched sweeps are what a
  /// person who walks ahead holds back. How it turned is told by the poses that were found.
  /// @param odom_from_robot at the sweep, and `map_from_robot` as it was found
  /// @returns how many points move
  int hide(Scan& scan, double timestamp_s, const Pose2& odom_from_robot,
           const Pose2& map_from_robot);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace roomatlas
