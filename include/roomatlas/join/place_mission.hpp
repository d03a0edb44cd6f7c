// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "roomatlas/core/progress.hpp"
#include "roomatlas/core/workers.hpp"
#include "roomatlas/locate/building_index.hpp"
#include "roomatlas/locate/query_rays.hpp"

namespace roomatlas {

/// What a mission measured of one of its visits against another.
struct OwnMeasurement {
  AsrId from = 0;
  AsrId to = 0;
  Pose2 from_from_to;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< in the frame of `to`
  bool is_closure = false;                                ///< matched by walls, not driven
};

/// A mission as others are matched with it: its visits, each where the mission's own correction
/// puts it.
struct MissionMap {
  std::vector<AsrShape> shapes;           ///< ascending by id, in the order of the drive
  Placement mission_from_asr;             ///< of each of them
  SensorKind sensor = SensorKind::laser;  ///< sonars' corrections bend more
  /// What its correction was made of; empty: only how it came out is known.
  std::vector<OwnMeasurement> measured;
  /// Where a second answer puts the visits, which the mission's readings allow nearly as well;
  /// empty where there is but one.
  Placement other_answer;
  /// Some readings of each visit, in its frame, spread over the whole mission.
  std::map<AsrId, std::vector<QueryRay>> rays;
};

struct PlaceMissionOptions {
  LocateOptions locate;
  double piece_way_m = 12.0;  ///< of path in a piece that is looked for: shorter ones look alike
  int min_piece_walls = 120;  ///< wall points in a piece; more makes pieces larger
  int searched_pieces = 12;   ///< spread over the mission; the others only where these fail
  int places_a_piece = 10;    ///< the likeliest that count as a vote
  int tried = 6;              ///< of the places of the whole mission, those that are followed
  double alike_m = 1.0;       ///< places of two pieces are one of the mission if they differ by
  double alike_deg = 3.0;     ///< less; missions bend
  double max_bend_m = 0.5;    ///< from one piece to the next ...
  double max_bend_deg = 3.0;  ///< ... and its turn
  int min_agreeing = 30;      ///< wall points of a piece that fits
  double min_piece_agreement = 0.65;  ///< of what can tell
  double min_agreement = 0.75;        ///< of the pieces inside what is known ...
  /// ... or so much where furniture was moved since: if so large a share of the whole path fits,
  /// and the next place has at most so large a share of its score. Of a lower score than this
  /// readings must say so too.
  struct Refurnished {
    double min_agreement = 0.6;
    double min_fitting = 1.0 / 3.0;
    double min_score = 300.0;
    double max_next = 0.25;  ///< of its score
  } refurnished;
  double min_path_on_floor = 0.5;  ///< of a piece that counts for a place: walls in line beyond
                                   ///< what the building knows prove nothing
  double min_score = 60.0;         ///< log likelihood of the whole mission
  double min_margin = 8.0;         ///< by which it exceeds that of any other place, and ...
  double margin_sigmas = 2.0;      ///< ... so many times its root: sums of many points err more
  /// Another building may reach 220, in several places alike, where a few corridors lie on each
  /// other: of a lower score than this, and if less of the path fits, the next place has at most so
  /// large a share.
  double sure_score = 400.0;
  double sure_fitting = 2.0 / 3.0;
  double max_next = 0.45;
};

/// A piece of a mission where it fits best.
struct PlacedPiece {
  std::vector<AsrId> visits;
  PlaceHypothesis place;   ///< of the mission's frame, as this piece has it
  bool is_inside = false;  ///< its path runs over floor that the building knows
  bool fits = false;
};

/// A place of a whole mission, followed piece by piece.
struct MissionPlace {
  Pose2 building_from_mission;  ///< where the piece puts it that was found first
  std::vector<PlacedPiece> pieces;
  double score = 0.0;     ///< log likelihood against a place taken at random, all pieces together
  int agreeing = 0;       ///< wall points of the pieces inside what the building knows ...
  int contradicting = 0;  ///< ... and theirs on floor, and floor on walls

  [[nodiscard]] double agreement() const {
    const int telling = agreeing + contradicting;
    return telling > 0 ? static_cast<double>(agreeing) / telling : 0.0;
  }
  [[nodiscard]] std::size_t fitting() const;
  /// Where each visit's piece puts the mission.
  [[nodiscard]] std::map<AsrId, Pose2> building_from_mission_by_visit() const;
};

enum class PlaceVerdict {
  placed,
  nothing_in_common,  ///< no place fits well enough
  ambiguous,          ///< two places fit nearly as well
};
[[nodiscard]] const char* to_string(PlaceVerdict verdict);

/// Whether furniture that was moved, doors that were shut, may be all that contradicts the first
/// place, as far as walls tell: most agree, and at no other place do they.
[[nodiscard]] bool may_be_refurnished(const std::vector<MissionPlace>& places,
                                      const PlaceMissionOptions& options);

/// Where a mission lies in a building of which nothing is known beforehand.
struct MissionSearch {
  PlaceVerdict verdict = PlaceVerdict::nothing_in_common;
  std::vector<MissionPlace> places;  ///< the likeliest first; may be empty
};

/// Looks for pieces of the mission all over the building, follows the places that several of them
/// agree on piece by piece, and judges.
/// @param workers the pieces, and the places that are followed, are shared among them
/// @throws Interrupted when `progress` says so
[[nodiscard]] MissionSearch place_mission(const MissionMap& mission, const BuildingIndex& building,
                                          const PlaceMissionOptions& options,
                                          const Progress& progress = {},
                                          const Workers& workers = {});

/// The sketch of all visits of a mission, in its frame.
[[nodiscard]] FloorSketch sketch_of(const MissionMap& mission);

}  // namespace roomatlas
