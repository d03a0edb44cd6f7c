// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <utility>

#include "door_probability.hpp"

namespace roomatlas {

/// Regions of the floor and the openings between them; begins with one region a piece.
class RegionGraph {
 public:
  RegionGraph(const FloorPieces& pieces, const CellFrame& frame,
              std::vector<PieceOpening> openings);

  using Pair = std::pair<std::int32_t, std::int32_t>;  ///< the smaller number first

  /// Joins two regions that touch; the larger one's number stays.
  /// @returns that number
  std::int32_t join(const Pair& pair);

  [[nodiscard]] const Region& region(std::int32_t number) const {
    return regions_[static_cast<std::size_t>(number)];
  }
  /// The regions that have not been joined to others, ascending.
  [[nodiscard]] std::vector<std::int32_t> regions() const;
  [[nodiscard]] std::vector<std::int32_t> neighbours(std::int32_t number) const;
  [[nodiscard]] std::vector<Pair> pairs() const;
  [[nodiscard]] bool touch(const Pair& pair) const;
  [[nodiscard]] std::vector<const PieceOpening*> openings(const Pair& pair) const;
  /// Whether a corridor goes on straight from one to the other.
  [[nodiscard]] bool share_corridor(const Pair& pair) const;
  [[nodiscard]] DoorFigures figures(const Pair& pair) const;
  /// The region that a piece has become part of; 0 for 0.
  [[nodiscard]] std::int32_t region_of(std::int32_t piece) const;

 private:
  using Openings = std::vector<std::size_t>;

  std::vector<PieceOpening> openings_;
  std::vector<Region> regions_;
  std::vector<std::int32_t> into_;
  std::vector<std::map<std::int32_t, Openings>> beside_;
};

struct JoinOptions {
  double min_door_probability = 0.45;
  double min_room_m2 = 2.0;
  double min_radius_m = 0.5;
};

[[nodiscard]] JoinOptions join_options(const PartitionOptions& options, bool is_mission);

/// Probabilities of doors between regions that are being joined.
class DoorQueue {
 public:
  DoorQueue(const RegionGraph& graph, const DoorWeights& model);
  [[nodiscard]] bool empty() const { return by_probability_.empty(); }
  /// The least probable door and its probability.
  [[nodiscard]] std::pair<double, RegionGraph::Pair> least() const {
    return *by_probability_.begin();
  }
  [[nodiscard]] double probability(const RegionGraph::Pair& pair) const {
    return probability_.at(pair);
  }
  /// Takes a pair out, for good.
  void drop(const RegionGraph::Pair& pair);
  /// Joins the two and asks again about all around them.
  /// @returns the pairs asked about
  std::vector<RegionGraph::Pair> join(RegionGraph& graph, const RegionGraph::Pair& pair);

 private:
  void ask(const RegionGraph& graph, const RegionGraph::Pair& pair);

  DoorWeights model_;
  std::map<RegionGraph::Pair, double> probability_;
  std::set<std::pair<double, RegionGraph::Pair>> by_probability_;
};

/// Joins what a cut across a corridor parts: however likely a door is made by it, there is none.
void join_corridors(RegionGraph& graph);

/// Joins regions until doors alone are left between them, then what is too small for a room.
/// @returns the probabilities of what is left
DoorQueue join_to_rooms(RegionGraph& graph, const DoorWeights& model, const JoinOptions& options);

}  // namespace roomatlas
