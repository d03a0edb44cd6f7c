// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/core/learnt_sum.hpp"
#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// When a visit counts as right: so near to where it truly was, in place and in heading, once the
/// whole mission is laid on the truth by least squares.
constexpr double kRightPlace_m = 0.25;
constexpr double kRightHeading_deg = 2.0;
/// A map or a room with a smaller probability is called doubtful.
constexpr double kTrusted = 0.9;
/// Visits together that drives are advised for; the covariance of all pairs is 160 MB then.
constexpr std::size_t kMostAdvised = 1500;

/// What is said of one visit.
struct VisitJudgement {
  AsrId asr = 0;
  RoomId room = 0;           ///< 0: of no room
  double probability = 0.0;  ///< that it is right, [0, 1]
  double place_m = 0.0;      ///< error bar of its place
  std::vector<JudgedFigure> figures;
};

/// What is said of one room: what its least sure visit allows.
struct RoomJudgement {
  RoomId room = 0;
  double probability = 0.0;  ///< that all its visits are right, [0, 1]
  double place_m = 0.0;      ///< error bar of its place
};

/// What lowers the probability.
struct Doubt {
  std::string text;           ///< a sentence without a full stop
  std::vector<RoomId> rooms;  ///< that it is about; empty: all of them
  double weight = 0.0;        ///< in log odds, larger lowers more
};

/// What to drive for a surer map.
enum class AdviceKind {
  cross_again,  ///< a passage that alone holds what is behind it
  drive_again,  ///< a chain of rooms
  use_door,     ///< a door between rooms that the robot did not go through: it closes a loop
};

[[nodiscard]] const char* to_string(AdviceKind kind);

/// A drive, and what it would do to the covariance of the visits' places. "Largest" is that of the
/// visit that is held most loosely, one standard deviation.
struct Advice {
  AdviceKind kind = AdviceKind::cross_again;
  AsrId from = 0;        ///< visits at whose walls the robot would look again, first ...
  AsrId to = 0;          ///< ... and last
  RoomId from_room = 0;  ///< of `from`
  RoomId to_room = 0;    ///< of `to`; the same where the way stays in one room
  bool by_door = false;  ///< the way between them is one door
  double drive_m = 0.0;  ///< its length, without the way to where it begins
  /// Largest once all advice ahead of it is followed, and once this is as well.
  double place_before_m = 0.0;
  double place_after_m = 0.0;
  double heading_before_deg = 0.0;
  double heading_after_deg = 0.0;
};

/// "drive once more through the door between rooms 3 and 4": without a full stop.
[[nodiscard]] std::string words(const Advice& advice);

/// How far a map can be relied on, as learnt from simulated missions whose truth is known
/// (docs/trust.md). Error bars are such that 9 of 10 of their kind hold.
struct Judgement {
  double probability = 0.0;  ///< that every visit is right, [0, 1]
  double place_m = 0.0;      ///< error bar of where rooms are, after fitting the whole
  double heading_deg = 0.0;  ///< the same of the largest heading error of a visit: bending
  double scale_share = 0.0;  ///< the same of the building's lengths, as a share of them
  std::vector<VisitJudgement> visits;  ///< ascending by ASR
  std::vector<RoomJudgement> rooms;    ///< ascending by room
  std::vector<Doubt> doubts;           ///< the strongest first
  std::vector<Advice> advice;  ///< what would help most a metre first; none for a trusted map
  std::vector<JudgedFigure> figures;  ///< of the map as a whole
};

}  // namespace roomatlas
