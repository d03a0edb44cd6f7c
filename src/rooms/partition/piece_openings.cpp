// SPDX-License-Identifier: GPL-3.0-or-later
#include "piece_openings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kOnChordShare = 0.6;      // of a border's cells beside one chord
constexpr double kOppositeCosine = -0.35;  // between the ways to two jambs
constexpr double kMinWidthM = 0.05;        // of an opening whose jambs were not found
constexpr std::array<Cell, 2> kNextSides = {Cell{1, 0}, Cell{0, 1}};

using PiecePair = std::pair<std::int32_t, std::int32_t>;
using Border = std::vector<Cell>;

struct ByRow {
  bool operator()(const Cell& a, const Cell& b) const { return a.y != b.y ? a.y < b.y : a.x < b.x; }
};

/// The cells of each two touching pieces that touch, row by row.
std::map<PiecePair, Border> borders_of(const Raster<std::int32_t>& piece_of_cell) {
  std::map<PiecePair, Border> borders;
  for_each_cell(piece_of_cell.domain, [&](const Cell& cell) {
    const std::int32_t here = piece_of_cell[cell];
    if (here == 0) return;
    for (const Cell& step : kNextSides) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      const std::int32_t there = piece_of_cell.get(next);
      if (there == 0 || there == here) continue;
      Border& border = borders[std::minmax(here, there)];
      border.push_back(cell);
      border.push_back(next);
    }
  });
  for (auto& [pair, border] : borders) {
    std::sort(border.begin(), border.end(), ByRow());
    border.erase(std::unique(border.begin(), border.end()), border.end());
  }
  return borders;
}

/// The 8-connected parts of a border.
std::vector<Border> connected_parts(const Border& border) {
  std::vector<bool> taken(border.size(), false);
  std::vector<Border> parts;
  for (std::size_t first = 0; first < border.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    Border part{border[first]};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Cell at = part[i];
      for (int dy = -1; dy <= 1; ++dy) {
        auto next =
            std::lower_bound(border.begin(), border.end(), Cell{at.x - 1, at.y + dy}, ByRow());
        for (; next != border.end() && next->y == at.y + dy && next->x <= at.x + 1; ++next) {
          const auto index = static_cast<std::size_t>(next - border.begin());
          if (taken[index]) continue;
          taken[index] = true;
          part.push_back(*next);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Jambs of an opening without a chord: the nearest obstacle to its widest cell, the obstacle
/// nearest to that one on the other side, and once more back.
class JambFinder {
 public:
  explicit JambFinder(const OpenFloor& floor) : floor_(floor) {}

  [[nodiscard]] std::optional<Segment2> jambs_at(const Cell& saddle) const {
    const double cells = floor_.clearance_m[saddle] / floor_.frame.cell_m;
    const int reach = static_cast<int>(1.6 * cells + 3.0);
    const std::vector<Cell> obstacles = obstacles_around(saddle, reach);
    const Cell* first = nearest(obstacles, saddle, saddle, saddle);
    if (first == nullptr) return std::nullopt;
    const Cell* second = nearest(obstacles, *first, saddle, *first);
    if (second == nullptr) return std::nullopt;
    const Cell* again = nearest(obstacles, *second, saddle, *second);
    const Point2 a = floor_.frame.center_of(again != nullptr ? *again : *first);
    const Point2 b = floor_.frame.center_of(*second);
    const double inset_m = std::min(0.5 * floor_.frame.cell_m, (b - a).norm() / 2.0);
    const Point2 inset = inset_m * (b - a).normalized();
    return Segment2{a + inset, b - inset};
  }

 private:
  /// Obstacle cells beside open ones.
  [[nodiscard]] std::vector<Cell> obstacles_around(const Cell& center, int reach) const {
    std::vector<Cell> cells;
    const CellMask& open = floor_.open;
    for (int y = center.y - reach; y <= center.y + reach; ++y) {
      for (int x = center.x - reach; x <= center.x + reach; ++x) {
        if (open.at({x, y})) continue;
        if (open.at({x + 1, y}) || open.at({x - 1, y}) || open.at({x, y + 1}) ||
            open.at({x, y - 1})) {
          cells.push_back({x, y});
        }
      }
    }
    return cells;
  }

  /// The cell nearest to `from` that lies on the other side of `middle` than `opposite`; any cell
  /// when `opposite` is `middle` itself.
  static const Cell* nearest(const std::vector<Cell>& cells, const Cell& from, const Cell& middle,
                             const Cell& opposite) {
    const Point2 away(opposite.x - middle.x, opposite.y - middle.y);
    const Cell* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Cell& cell : cells) {
      const double apart = distance_cells(cell, from);
      if (apart >= least) continue;
      const Point2 way(cell.x - middle.x, cell.y - middle.y);
      if (!(opposite == middle) && way.dot(away) >= kOppositeCosine * way.norm() * away.norm()) {
        continue;
      }
      least = apart;
      best = &cell;
    }
    return best;
  }

  const OpenFloor& floor_;
};

/// The chord that most of a border's cells touch; 0: none does.
std::int32_t chord_beside(const Border& border, const ChordCells& chord_cells) {
  std::map<std::int32_t, std::size_t> touching;
  std::size_t any = 0;
  for (const Cell& cell : border) {
    std::int32_t chord = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        chord = std::max(chord, chord_cells.at({cell.x + dx, cell.y + dy}));
      }
    }
    if (chord == 0) continue;
    ++any;
    ++touching[chord];
  }
  if (static_cast<double>(any) <= kOnChordShare * static_cast<double>(border.size())) return 0;
  return std::max_element(touching.begin(), touching.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// How far a border reaches, in any direction of its bounding box.
double extent_m(const Border& border, const CellFrame& frame) {
  Box2 box;
  for (const Cell& cell : border) box.extend(frame.center_of(cell));
  return box.size().norm();
}

void take_support(const OpenFloor& floor, PieceOpening& opening) {
  const Point2 way = opening.jambs.b - opening.jambs.a;
  if (way.norm() < floor.frame.cell_m) return;
  const Point2 along = way.normalized();
  const WallSupport a = wall_support(floor, opening.jambs.a, -along);
  const WallSupport b = wall_support(floor, opening.jambs.b, along);
  opening.lower = {std::min(a.near, b.near), std::min(a.middle, b.middle), std::min(a.far, b.far)};
  opening.higher = {std::max(a.near, b.near), std::max(a.middle, b.middle), std::max(a.far, b.far)};
}

PieceOpening on_chord_line(const WallChord& chord, const Border& border, const OpenFloor& floor) {
  PieceOpening opening;
  opening.is_on_chord = true;
  opening.is_known = chord.is_known;
  opening.jambs = chord.line;
  opening.width_m = std::min(chord.length_m(), extent_m(border, floor.frame));
  return opening;
}

PieceOpening at_saddle(const JambFinder& finder, const Border& border, const OpenFloor& floor) {
  const Cell saddle = *std::max_element(
      border.begin(), border.end(),
      [&](const Cell& a, const Cell& b) { return floor.clearance_m[a] < floor.clearance_m[b]; });
  PieceOpening opening;
  if (const std::optional<Segment2> jambs = finder.jambs_at(saddle)) {
    opening.jambs = *jambs;
    opening.width_m = (jambs->b - jambs->a).norm();
  } else {
    opening.jambs = {floor.frame.center_of(saddle), floor.frame.center_of(saddle)};
    opening.width_m = 2.0 * floor.clearance_m[saddle];
  }
  return opening;
}

/// What is asked of every opening.
void finish(const OpenFloor& floor, const PiecePair& pair, PieceOpening& opening) {
  opening.piece_a = pair.first;
  opening.piece_b = pair.second;
  opening.width_m = std::max(opening.width_m, kMinWidthM);
  take_support(floor, opening);
  opening.passage = passage_at(floor, opening.jambs);
}

}  // namespace

std::vector<PieceOpening> find_piece_openings(const OpenFloor& floor, const FloorPieces& pieces,
                                              const std::vector<WallChord>& chords,
                                              const ChordCells& chord_cells) {
  const JambFinder finder(floor);
  std::vector<PieceOpening> openings;
  for (const auto& [pair, border] : borders_of(pieces.piece_of_cell)) {
    std::map<std::int32_t, Border> on_chord;  // all that lies on one chord is one opening
    std::vector<Border> elsewhere;
    for (Border& part : connected_parts(border)) {
      const std::int32_t chord = chord_beside(part, chord_cells);
      if (chord == 0) {
        elsewhere.push_back(std::move(part));
      } else {
        Border& all = on_chord[chord];
        all.insert(all.end(), part.begin(), part.end());
      }
    }
    for (const auto& [chord, part] : on_chord) {
      openings.push_back(on_chord_line(chords[static_cast<std::size_t>(chord - 1)], part, floor));
      finish(floor, pair, openings.back());
    }
    for (const Border& part : elsewhere) {
      openings.push_back(at_saddle(finder, part, floor));
      finish(floor, pair, openings.back());
    }
  }
  return openings;
}

void count_crossings(const std::vector<Pose2>& path, const CellFrame& frame,
                     const FloorPieces& pieces, std::vector<PieceOpening>& openings) {
  std::map<PiecePair, std::vector<std::size_t>> of_pair;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    of_pair[{openings[i].piece_a, openings[i].piece_b}].push_back(i);
  }
  const auto cross = [&](std::int32_t from, std::int32_t to, const Point2& at) {
    const auto found = of_pair.find(std::minmax(from, to));
    if (found == of_pair.end()) return;
    const auto nearest = std::min_element(
        found->second.begin(), found->second.end(), [&](std::size_t a, std::size_t b) {
          return distance(openings[a].jambs, at) < distance(openings[b].jambs, at);
        });
    ++openings[*nearest].crossings;
  };
  std::int32_t last = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    for_each_cell_on_line(frame.cell_of(path[i - 1].position()), frame.cell_of(path[i].position()),
                          [&](const Cell& cell) {
                            const std::int32_t here = pieces.piece_of_cell.get(cell);
                            if (here == 0) return true;
                            if (last != 0 && here != last) cross(last, here, frame.center_of(cell));
                            last = here;
                            return true;
                          });
  }
}

}  // namespace roomatlas
