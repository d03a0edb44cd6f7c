// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// Which way the robot went. Some robots' odometry never reports a backward step, so that each one
/// counts double (fr079 is such a log). A robot turns from forwards to backwards only where it
/// stops: one direction holds for the whole drive from a stop to the next, and what was seen on the
/// way, carried along the reported motion and against it, tells which.
enum class DriveDirection {
  as_reported,
  undecided,  ///< the readings do not tell: taken as reported
  reversed,   ///< backwards where odometry reported forwards
};

/// What `DeadReckoner` alone needs: it decides with the laser's next few readings.
struct StreamEvidenceOptions {
  double flip_log_odds_per_pair = 7.0;  ///< least evidence of a pair on average. True reversals
                                        ///< give 9 and more, a smooth corridor up to 3.4 under bad
                                        ///< odometry, sonars up to 6.4; smaller flips falsely
};

/// What `find_drive_directions` alone needs: it decides with all that few cones heard on a drive.
struct MissionEvidenceOptions {
  double max_turn_rad = 0.9;  ///< between two readings; farther turned, other cones look there
  double other_share = 0.3;   ///< likelihood of a return on something else, the peak being 1;
                              ///< smaller lets one stray echo decide
  double independence = 0.3;  ///< share of the evidence that is new: pairs overlap; larger flips
                              ///< falsely
  double clear_log_odds_per_pair = 0.4;  ///< least evidence of a pair that tells, on average, of a
                                         ///< drive that is clearly reversed. Most backward steps of
                                         ///< fr079 give 0.5 to 1.5, few cones along a wall up to
                                         ///< 0.26, which a long drive adds up to 30
  int forward_drives = 5;  ///< that were clearly driven forwards, and none backwards, show that the
                           ///< robot does not drive backwards
};

/// How the direction of a drive is decided, on a stream and for a whole mission alike.
struct DriveDirectionOptions {
  bool find_reverse = true;     ///< off: odometry is taken as it is
  double stop_step_m = 0.03;    ///< a shorter step is a stop and ends a drive. Larger cuts slow
                                ///< drives into pieces too short to tell, smaller overlooks stops
  double min_apart_m = 0.18;    ///< pairs of readings nearer than this cannot tell: their ranges
                                ///< differ by noise
  double max_apart_m = 0.55;    ///< farther ones see too different things
  double range_sigma_m = 0.08;  ///< agreement of two readings of one wall; smaller takes furniture
                                ///< and drift for evidence
  double flip_log_odds = 3.0;   ///< evidence needed to reverse a drive. With it 74 of 88 backward
                                ///< steps of fr079 are found, none falsely; smaller flips falsely
  double undecided_log_odds = -1.5;  ///< evidence above it, of a drive that is not reversed, leaves
                                     ///< it undecided
  StreamEvidenceOptions stream;
  MissionEvidenceOptions mission;
};

/// Which way the robot went in each step of a mission.
struct DriveDirections {
  std::vector<DriveDirection> of_step;  ///< of the step that leads to each reading
  std::vector<double> undecided_m;      ///< path up to each reading in drives that stay undecided,
                                        ///< not decreasing
  int drives_reversed = 0;
  bool odometry_is_signed = false;  ///< it reports backward steps itself: nothing was looked for
};

/// A step as it was driven: the reported one, or that with its translation negated.
[[nodiscard]] Pose2 driven(const Pose2& reported_step, DriveDirection direction);

/// Decides for a whole mission, by cones: returns of one reading are carried into a later one's
/// cones both ways, and the ranges heard there decide. Each return counts by itself, since a ring
/// has few; the readings of the stop before and behind are compared, too. A drive whose pairs say
/// little each is reversed only in a mission in which more drives clearly are, and nothing is
/// undecided in one whose robot clearly drives forwards alone (`forward_drives`). `DeadReckoner`
/// decides on a stream, where no later drive is known yet: its answer is for the first mapping,
/// this one for the correction of the mission, and where both were asked this one holds.
/// @returns one entry a reading; empty for none. Only steps to and from readings of the sensor that
///   is read most often decide, no two of them within 0.15 s
[[nodiscard]] DriveDirections find_drive_directions(std::span<const RangeReading> readings,
                                                    const DriveDirectionOptions& options);

}  // namespace roomatlas
