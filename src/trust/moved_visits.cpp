// SPDX-License-Identifier: GPL-3.0-or-later
#include "moved_visits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomatlas {
namespace {

constexpr MoveSize kUnknown{10.0, kPi};
constexpr double kLeastOff = 0.01;

/// How far one solution moves a visit.
MoveSize size_of(const Pose2& move, const Point2& centre) {
  return {(move * centre - centre).norm(), std::abs(move.theta_rad)};
}

void add_square(const MoveSize& one, double weight, MoveSize& sum) {
  sum.place_m += weight * one.place_m * one.place_m;
  sum.heading_rad += weight * one.heading_rad * one.heading_rad;
}

MoveSize root_of(const MoveSize& squares) {
  return {std::sqrt(squares.place_m), std::sqrt(squares.heading_rad)};
}

MapMoves unknown(const std::map<AsrId, Point2>& centres) {
  MapMoves moves{kUnknown.place_m, kUnknown, std::log(kUnknown.place_m / kRightPlace_m), {}};
  for (const auto& [asr, centre] : centres) moves.visits[asr] = kUnknown;
  return moves;
}

}  // namespace

MapMoves map_moves(const MovedVisits& moved, const std::map<AsrId, Point2>& centres) {
  if (moved.empty()) return unknown(centres);
  MapMoves moves;
  const std::size_t solutions = moved.begin()->second.size();
  const double share = 1.0 / static_cast<double>(solutions);
  for (std::size_t i = 0; i < solutions; ++i) {
    MoveSize most;
    for (const auto& [asr, centre] : centres) {
      const MoveSize size = size_of(moved.at(asr)[i], centre);
      most.place_m = std::max(most.place_m, size.place_m);
      most.heading_rad = std::max(most.heading_rad, size.heading_rad);
      add_square(size, share, moves.visits[asr]);
    }
    add_square(most, share, moves.worst);
    const double off =
        std::max(most.place_m / kRightPlace_m, degrees(most.heading_rad) / kRightHeading_deg);
    moves.log_off += share * std::log(std::max(kLeastOff, off));
  }
  moves.worst = root_of(moves.worst);
  for (auto& [asr, visit] : moves.visits) {
    moves.place_m += visit.place_m / static_cast<double>(centres.size());
    visit = root_of(visit);
  }
  moves.place_m = std::sqrt(moves.place_m);
  return moves;
}

}  // namespace roomatlas
