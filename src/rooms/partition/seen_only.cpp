// SPDX-License-Identifier: GPL-3.0-or-later
#include "seen_only.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace roomatlas {
namespace {

constexpr double kMostUnseenRim = 0.5;  // share of a piece's whole rim; more was looked into
constexpr double kLeastWallRim = 0.55;  // share of a region's rim without openings; less is no room
constexpr double kMinRoomM2 = 4.0;      // a smaller one that was not entered is a glimpse
constexpr std::array<Cell, 4> kSides = {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}};

/// What ends a part of the floor; edges of cells.
struct Rim {
  double walls = 0.0;
  double unseen = 0.0;
  double openings = 0.0;
  double cells = 0.0;  ///< of the part itself
};

template <typename PartOf>
std::map<std::int32_t, Rim> rims(const CutBuilding& cut, PartOf part_of) {
  std::map<std::int32_t, Rim> rim_of;
  for_each_cell(cut.floor.open.domain, [&](const Cell& cell) {
    const std::int32_t part = part_of(cell);
    if (part == 0) return;
    Rim& rim = rim_of[part];
    ++rim.cells;
    for (const Cell& step : kSides) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (cut.floor.open.at(next)) {
        if (part_of(next) != part) ++rim.openings;
      } else if (cut.floor.solid.at(next)) {
        ++rim.walls;
      } else {
        ++rim.unseen;
      }
    }
  });
  return rim_of;
}

template <typename PartOf>
std::set<std::int32_t> entered(const CutBuilding& cut, const std::vector<Pose2>& path,
                               PartOf part_of) {
  std::set<std::int32_t> parts;
  for (const Pose2& pose : path) parts.insert(part_of(cut.floor.frame.cell_of(pose.position())));
  return parts;
}

/// Of each piece the group of pieces that it is in with no chord between.
std::vector<std::int32_t> groups_between_chords(const CutBuilding& cut) {
  std::vector<std::int32_t> into(static_cast<std::size_t>(cut.pieces.count) + 1);
  std::iota(into.begin(), into.end(), 0);
  const auto root = [&](std::int32_t piece) {
    while (into[static_cast<std::size_t>(piece)] != piece) {
      piece = into[static_cast<std::size_t>(piece)];
    }
    return piece;
  };
  for (const PieceOpening& opening : cut.openings) {
    if (opening.is_on_chord) continue;
    const std::int32_t a = root(opening.piece_a);
    const std::int32_t b = root(opening.piece_b);
    into[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::vector<std::int32_t> group_of(into.size());
  for (std::size_t i = 0; i < into.size(); ++i) {
    group_of[i] = root(static_cast<std::int32_t>(i));
  }
  return group_of;
}

}  // namespace

void drop_seen_through_walls(const std::vector<Pose2>& path, CutBuilding& cut) {
  if (path.empty()) return;
  const std::vector<std::int32_t> group_of = groups_between_chords(cut);
  const auto group_at = [&](const Cell& cell) {
    return group_of[static_cast<std::size_t>(cut.pieces.piece_of_cell.get(cell))];
  };
  const std::set<std::int32_t> kept = entered(cut, path, group_at);
  std::set<std::int32_t> dropped;
  for (const auto& [group, rim] : rims(cut, group_at)) {
    if (kept.contains(group)) continue;
    if (rim.unseen > kMostUnseenRim * (rim.unseen + rim.walls + rim.openings)) {
      dropped.insert(group);
    }
  }
  const auto is_dropped = [&](std::int32_t piece) {
    return dropped.contains(group_of[static_cast<std::size_t>(piece)]);
  };
  std::erase_if(cut.openings, [&](const PieceOpening& opening) {
    return is_dropped(opening.piece_a) || is_dropped(opening.piece_b);
  });
  for (std::int32_t& piece : cut.pieces.piece_of_cell.values) {
    if (is_dropped(piece)) piece = 0;
  }
}

std::set<std::int32_t> regions_not_known(const CutBuilding& cut, const RegionGraph& graph,
                                         const std::vector<Pose2>& path) {
  std::set<std::int32_t> regions;
  if (path.empty()) return regions;
  const auto region_of = [&](const Cell& cell) {
    return graph.region_of(cut.pieces.piece_of_cell.get(cell));
  };
  const std::set<std::int32_t> kept = entered(cut, path, region_of);
  const double cell_m2 = cut.floor.frame.cell_m * cut.floor.frame.cell_m;
  for (const auto& [region, rim] : rims(cut, region_of)) {
    if (kept.contains(region)) continue;
    if (rim.cells * cell_m2 < kMinRoomM2 || rim.walls < kLeastWallRim * (rim.walls + rim.unseen)) {
      regions.insert(region);
    }
  }
  return regions;
}

}  // namespace roomatlas
