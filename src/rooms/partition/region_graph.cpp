// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_graph.hpp"

#include <algorithm>
#include <numeric>

#include "roomatlas/core/convex_hull.hpp"

namespace roomatlas {
namespace {

constexpr double kKnownWall =
    2.5;  // added to the exponent of openings in walls that are known:
          // maps of cells alone, from which the rest was learned, know none
constexpr double kMinCorridorM = 0.7;  // narrower gaps between straight walls are no corridors

std::size_t at(std::int32_t number) { return static_cast<std::size_t>(number); }

/// The corners of the first and last cell of each of a piece's rows.
std::vector<std::vector<Point2>> row_ends(const FloorPieces& pieces, const CellFrame& frame) {
  std::vector<std::vector<Point2>> ends(at(pieces.count) + 1);
  const auto add = [&](std::int32_t piece, int corner_x, int y) {
    if (piece == 0) return;
    ends[at(piece)].emplace_back(corner_x * frame.cell_m, y * frame.cell_m);
    ends[at(piece)].emplace_back(corner_x * frame.cell_m, (y + 1) * frame.cell_m);
  };
  const CellDomain& domain = pieces.piece_of_cell.domain;
  for (int y = domain.bounds().min.y; y < domain.bounds().max.y; ++y) {
    domain.for_each_span(y, [&](const CellDomain::Span& span) {
      std::int32_t last = 0;
      for (int x = span.from; x < span.to; ++x) {
        const std::int32_t here = pieces.piece_of_cell[{x, y}];
        if (here == last) continue;
        add(last, x, y);
        add(here, x, y);
        last = here;
      }
      add(last, span.to, y);
    });
  }
  return ends;
}

}  // namespace

RegionGraph::RegionGraph(const FloorPieces& pieces, const CellFrame& frame,
                         std::vector<PieceOpening> openings)
    : openings_(std::move(openings)),
      regions_(at(pieces.count) + 1),
      into_(at(pieces.count) + 1),
      beside_(at(pieces.count) + 1) {
  std::iota(into_.begin(), into_.end(), 0);
  const double cell_m2 = frame.cell_m * frame.cell_m;
  for (const std::int32_t piece : pieces.piece_of_cell.values) {
    regions_[at(piece)].area_m2 += cell_m2;
  }
  const std::vector<std::vector<Point2>> ends = row_ends(pieces, frame);
  for (std::size_t i = 1; i < regions_.size(); ++i) {
    regions_[i].radius_m = pieces.radius_m[i];
    regions_[i].hull = convex_hull(ends[i]);
    regions_[i].hull_m2 = signed_area(regions_[i].hull);
  }
  for (std::size_t i = 0; i < openings_.size(); ++i) {
    beside_[at(openings_[i].piece_a)][openings_[i].piece_b].push_back(i);
    beside_[at(openings_[i].piece_b)][openings_[i].piece_a].push_back(i);
  }
}

std::int32_t RegionGraph::join(const Pair& pair) {
  const bool first_is_larger = region(pair.first).area_m2 >= region(pair.second).area_m2;
  const std::int32_t kept = first_is_larger ? pair.first : pair.second;
  const std::int32_t gone = first_is_larger ? pair.second : pair.first;
  Region& to = regions_[at(kept)];
  const Region& from = regions_[at(gone)];
  to.area_m2 += from.area_m2;
  to.radius_m = std::max(to.radius_m, from.radius_m);
  to.hull.insert(to.hull.end(), from.hull.begin(), from.hull.end());
  to.hull = convex_hull(to.hull);
  to.hull_m2 = signed_area(to.hull);
  into_[at(gone)] = kept;
  beside_[at(kept)].erase(gone);
  beside_[at(gone)].erase(kept);
  for (const auto& [other, openings] : beside_[at(gone)]) {
    Openings& joined = beside_[at(kept)][other];
    joined.insert(joined.end(), openings.begin(), openings.end());
    beside_[at(other)].erase(gone);
    beside_[at(other)][kept] = joined;
  }
  beside_[at(gone)].clear();
  return kept;
}

std::vector<std::int32_t> RegionGraph::regions() const {
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 1; i < into_.size(); ++i) {
    if (at(into_[i]) == i) numbers.push_back(into_[i]);
  }
  return numbers;
}

std::vector<std::int32_t> RegionGraph::neighbours(std::int32_t number) const {
  std::vector<std::int32_t> others;
  for (const auto& [other, openings] : beside_[at(number)]) others.push_back(other);
  return others;
}

std::vector<RegionGraph::Pair> RegionGraph::pairs() const {
  std::vector<Pair> all;
  for (const std::int32_t number : regions()) {
    for (const auto& [other, openings] : beside_[at(number)]) {
      if (number < other) all.emplace_back(number, other);
    }
  }
  return all;
}

bool RegionGraph::touch(const Pair& pair) const {
  return beside_[at(pair.first)].contains(pair.second);
}

std::vector<const PieceOpening*> RegionGraph::openings(const Pair& pair) const {
  std::vector<const PieceOpening*> between;
  for (const std::size_t i : beside_[at(pair.first)].at(pair.second)) {
    between.push_back(&openings_[i]);
  }
  return between;
}

bool RegionGraph::share_corridor(const Pair& pair) const {
  const std::vector<const PieceOpening*> all = openings(pair);
  if (known_share(pair) > 0.0) return false;  // it runs along a wall with doors
  return std::any_of(all.begin(), all.end(), [](const PieceOpening* opening) {
    return opening->width_m >= kMinCorridorM && is_across_corridor(opening->passage);
  });
}

DoorFigures RegionGraph::figures(const Pair& pair) const {
  const Region& a = region(pair.first);
  const Region& b = region(pair.second);
  return a.area_m2 <= b.area_m2 ? door_figures(a, b, openings(pair))
                                : door_figures(b, a, openings(pair));
}

double RegionGraph::known_share(const Pair& pair) const {
  double known_m = 0.0;
  double all_m = 0.0;
  for (const PieceOpening* opening : openings(pair)) {
    all_m += opening->width_m;
    if (opening->is_known) known_m += opening->width_m;
  }
  return all_m > 0.0 ? known_m / all_m : 0.0;
}

std::int32_t RegionGraph::region_of(std::int32_t piece) const {
  while (into_[at(piece)] != piece) piece = into_[at(piece)];
  return piece;
}

DoorQueue::DoorQueue(const RegionGraph& graph, const DoorWeights& model) : model_(model) {
  for (const RegionGraph::Pair& pair : graph.pairs()) ask(graph, pair);
}

void DoorQueue::drop(const RegionGraph::Pair& pair) {
  const auto found = probability_.find(pair);
  if (found == probability_.end()) return;
  by_probability_.erase({found->second, pair});
  probability_.erase(found);
}

std::vector<RegionGraph::Pair> DoorQueue::join(RegionGraph& graph, const RegionGraph::Pair& pair) {
  for (const std::int32_t one : {pair.first, pair.second}) {
    for (const std::int32_t other : graph.neighbours(one)) drop(std::minmax(one, other));
  }
  const std::int32_t joined = graph.join(pair);
  std::vector<RegionGraph::Pair> asked;
  for (const std::int32_t other : graph.neighbours(joined)) {
    asked.emplace_back(std::min(joined, other), std::max(joined, other));
    ask(graph, asked.back());
  }
  return asked;
}

void DoorQueue::ask(const RegionGraph& graph, const RegionGraph::Pair& pair) {
  DoorWeights model = model_;
  model.bias += kKnownWall * graph.known_share(pair);
  const double probability =
      door_probability(graph.figures(pair), model, driven_wide(graph.openings(pair)));
  probability_[pair] = probability;
  by_probability_.insert({probability, pair});
}

JoinOptions join_options(const PartitionOptions& options, bool is_mission) {
  return {options.min_door_probability,
          is_mission ? options.min_driven_room_m2 : options.min_room_m2, options.min_room_radius_m};
}

void join_corridors(RegionGraph& graph) {
  for (bool any = true; any;) {
    any = false;
    for (const RegionGraph::Pair& pair : graph.pairs()) {
      if (!graph.touch(pair) || !graph.share_corridor(pair)) continue;
      graph.join(pair);
      any = true;
    }
  }
}

DoorQueue join_to_rooms(RegionGraph& graph, const DoorWeights& model, const JoinOptions& options) {
  join_corridors(graph);
  DoorQueue queue(graph, model);
  while (!queue.empty() && queue.least().first < options.min_door_probability) {
    queue.join(graph, queue.least().second);
  }
  while (true) {
    std::int32_t smallest = 0;
    for (const std::int32_t number : graph.regions()) {
      const Region& region = graph.region(number);
      if (region.area_m2 >= options.min_room_m2 && region.radius_m >= options.min_radius_m) {
        continue;
      }
      if (graph.neighbours(number).empty()) continue;
      if (smallest == 0 || region.area_m2 < graph.region(smallest).area_m2) smallest = number;
    }
    if (smallest == 0) return queue;
    RegionGraph::Pair least;
    double probability = 2.0;
    for (const std::int32_t other : graph.neighbours(smallest)) {
      const RegionGraph::Pair pair = std::minmax(smallest, other);
      if (queue.probability(pair) >= probability) continue;
      probability = queue.probability(pair);
      least = pair;
    }
    queue.join(graph, least);
  }
}

}  // namespace roomatlas
