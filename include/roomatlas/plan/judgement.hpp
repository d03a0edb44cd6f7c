// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/plan/ids.hpp"

namespace roomatlas {

/// When a visit counts as right: so near to where it truly was, in place and in heading, once the
/// whole mission is laid on the truth by least squares.
constexpr double kRightPlace_m = 0.25;
constexpr double kRightHeading_deg = 2.0;
/// A map or a room with a smaller probability is called doubtful.
constexpr double kTrusted = 0.9;

/// One figure that a judgement is made from.
struct JudgedFigure {
  std::string name;
  double value = 0.0;
};

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
  std::vector<JudgedFigure> figures;   ///< of the map as a whole
};

}  // namespace roomatlas
