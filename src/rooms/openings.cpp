// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/rooms/openings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomatlas/core/place_index.hpp"

namespace roomatlas {
namespace {

constexpr int kHeadings = 24;         // chord directions in a half turn
constexpr double kMinChordM = 0.35;   // narrower does not let a robot through
constexpr double kOffCenterM = 0.11;  // a chord is measured from near its mid-point
constexpr double kPassableM = 0.45;   // each way across the chord
constexpr double kSideReachM = 1.5;   // how wide the space beside a chord is measured ...
constexpr double kSideFromM = 0.4;    // ... from this far off it: nearer is inside a thick wall ...
constexpr double kSideToM = 0.85;     // ... to 0.8 m, and a rounding: farther misses small lobbies
constexpr double kAskOffEveryM = 0.1;   // off the chord, and along the line beyond a jamb
constexpr double kAsWideM = 1e-9;       // chords that differ by less: the first heading stays
constexpr double kJambSlackM = 0.15;    // beyond a jamb the space is wider by this ...
constexpr double kJambSlope = 0.3;      // ... and this for each metre from the chord
constexpr double kBesideM = 0.8;        // how far beyond a jamb wall is asked for
constexpr double kBesideBandM = 0.2;    // a wall may be this far off the chord's line
constexpr double kOneOpeningM = 0.7;    // chords this near are of one opening
constexpr double kSamePassageM = 0.45;  // a narrower chord this near is of the same passage
constexpr double kMaxDepthM = 0.5;      // of a passage, from a chord in it
constexpr double kPeakReachM = 0.3;     // beyond the first obstacle the peak of hits is looked for
constexpr double kPeakBandM = 0.15;     // hits this far off the chord's line count
constexpr double kAsNarrowM = 0.1;      // the best chord of an opening is this near its narrowest

struct Chord {
  Doorway opening;
  double width_m = 0.0;
  bool is_opening = false;
};

class Chords {
 public:
  Chords(const BuildingGrid& grid, const OpeningOptions& options)
      : grid_(grid), options_(options), step_m_(grid.frame.cell_m / 2.0) {
    const double reach_m = options.max_width_m / 2.0 + kOffCenterM;
    for (int i = 0; i < 2 * kHeadings; ++i) {
      const Point2 along = direction(kPi * i / kHeadings + kPi / 2.0);
      std::vector<CellStep>& ray = rays_.emplace_back();
      for (double at_m = step_m_; at_m <= reach_m; at_m += step_m_) {
        const Point2 cells = Point2(0.5, 0.5) + at_m / grid.frame.cell_m * along;
        ray.push_back(
            {{static_cast<int>(std::floor(cells.x())), static_cast<int>(std::floor(cells.y()))},
             at_m});
      }
    }
  }

  /// The opening in the middle of its passage: chords as narrow follow each other through a wall.
  [[nodiscard]] Doorway centered(const Doorway& opening) const {
    const Point2 along = direction(opening.frame_from_pivot.theta_rad);
    const double limit_m = opening.width_m + kAsNarrowM;
    const auto reach = [&](double sign) {
      double reached_m = 0.0;
      for (double off_m = step_m_; off_m <= kMaxDepthM; off_m += step_m_) {
        const auto chord =
            chord_through(opening.frame_from_pivot.position() + sign * off_m * along, opening);
        if (!chord || chord->width_m > limit_m) break;
        reached_m = off_m;
      }
      return reached_m;
    };
    const double off_m = (reach(1.0) - reach(-1.0)) / 2.0;
    return chord_through(opening.frame_from_pivot.position() + off_m * along, opening)
        .value_or(opening);
  }

  [[nodiscard]] std::optional<Chord> narrowest_at(const Cell& cell) const {
    std::optional<Chord> best;
    const Point2 at = grid_.frame.center_of(cell);
    for (int i = 0; i < kHeadings; ++i) {
      const auto to_left_m = obstacle_on(rays_[static_cast<std::size_t>(i)], cell);
      if (!to_left_m) continue;
      const auto to_right_m = obstacle_on(rays_[static_cast<std::size_t>(i + kHeadings)], cell);
      if (!to_right_m || std::abs(*to_left_m - *to_right_m) > kOffCenterM) continue;
      const double width_m = *to_left_m + *to_right_m;
      if (best && width_m > best->width_m - kAsWideM) continue;
      const double heading_rad = kPi * i / kHeadings;
      const Point2 left = direction(heading_rad + kPi / 2.0);
      best = Chord{doorway_between({at + *to_left_m * left, at - *to_right_m * left}, heading_rad),
                   width_m};
    }
    if (!best || best->width_m < kMinChordM || best->width_m > options_.max_width_m ||
        !can_be_crossed(best->opening)) {
      return std::nullopt;
    }
    best->is_opening = is_opening(best->opening);
    return best;
  }

 private:
  /// A cell on a ray from the middle of a cell, seen from there.
  struct CellStep {
    Cell cell;
    double at_m = 0.0;
  };
  /// Distance along a ray from the middle of a cell to the first obstacle.
  [[nodiscard]] std::optional<double> obstacle_on(const std::vector<CellStep>& ray,
                                                  const Cell& from) const {
    for (const CellStep& step : ray) {
      if (grid_.obstacle.at({from.x + step.cell.x, from.y + step.cell.y})) return step.at_m;
    }
    return std::nullopt;
  }

  /// Distance along `along` to the first obstacle; nothing within `reach_m`.
  [[nodiscard]] std::optional<double> obstacle_along(const Point2& from, const Point2& along,
                                                     double reach_m) const {
    for (double at_m = step_m_; at_m <= reach_m; at_m += step_m_) {
      if (grid_.obstacle.at(grid_.frame.cell_of(from + at_m * along))) return at_m;
    }
    return std::nullopt;
  }

  /// The chord through a point, parallel to an opening.
  [[nodiscard]] std::optional<Doorway> chord_through(const Point2& at,
                                                     const Doorway& parallel) const {
    const Point2 left = direction(parallel.frame_from_pivot.theta_rad + kPi / 2.0);
    const auto to_left_m = obstacle_along(at, left, kSideReachM);
    const auto to_right_m = obstacle_along(at, -left, kSideReachM);
    if (!to_left_m || !to_right_m) return std::nullopt;
    return doorway_between({at + *to_left_m * left, at - *to_right_m * left},
                           parallel.frame_from_pivot.theta_rad);
  }

  [[nodiscard]] bool can_be_crossed(const Doorway& opening) const {
    const Point2 along = direction(opening.frame_from_pivot.theta_rad);
    for (double off_m = -kPassableM; off_m <= kPassableM; off_m += step_m_) {
      if (!grid_.passable.at(
              grid_.frame.cell_of(opening.frame_from_pivot.position() + off_m * along)))
        return false;
    }
    return true;
  }

  /// The space on one side of a chord.
  struct Side {
    double width_m = 0.0;
    bool wider_left = false;
    bool wider_right = false;
  };
  [[nodiscard]] Side side_of(const Doorway& opening, double sign) const {
    const Point2 along = sign * direction(opening.frame_from_pivot.theta_rad);
    const Point2 left = direction(opening.frame_from_pivot.theta_rad + kPi / 2.0);
    Side side;
    for (double off_m = kSideFromM; off_m < kSideToM; off_m += kAskOffEveryM) {
      const Point2 at = opening.frame_from_pivot.position() + off_m * along;
      if (!grid_.passable.at(grid_.frame.cell_of(at))) continue;
      const double to_left_m = obstacle_along(at, left, kSideReachM).value_or(kSideReachM);
      const double to_right_m = obstacle_along(at, -left, kSideReachM).value_or(kSideReachM);
      const double wider_m = opening.width_m / 2.0 + kJambSlackM + kJambSlope * off_m;
      side.width_m = std::max(side.width_m, to_left_m + to_right_m);
      side.wider_left |= to_left_m > wider_m;
      side.wider_right |= to_right_m > wider_m;
    }
    return side;
  }

  /// Share of the chord's line beyond a jamb that is not free.
  [[nodiscard]] double share_beside(const Doorway& opening, const Point2& jamb) const {
    const Point2 outward = (jamb - opening.frame_from_pivot.position()).normalized();
    const Point2 across(-outward.y(), outward.x());
    int asked = 0;
    int open = 0;
    for (double off_m = kAskOffEveryM; off_m <= kBesideM; off_m += kAskOffEveryM) {
      bool all_free = true;
      for (double band_m = -kBesideBandM; band_m <= kBesideBandM; band_m += step_m_) {
        all_free &= grid_.free.at(grid_.frame.cell_of(jamb + off_m * outward + band_m * across));
      }
      ++asked;
      open += all_free ? 1 : 0;
    }
    return 1.0 - static_cast<double>(open) / asked;
  }

  [[nodiscard]] bool is_opening(const Doorway& opening) const {
    const double width_m = opening.width_m;
    if (width_m < options_.min_width_m) return false;
    const Side ahead = side_of(opening, 1.0);
    const Side behind = side_of(opening, -1.0);
    const double needed_m = width_m + options_.widening_m;
    if (ahead.width_m < needed_m || behind.width_m < needed_m) return false;
    const bool has_both_jambs =
        (ahead.wider_left && ahead.wider_right) || (behind.wider_left && behind.wider_right);
    return has_both_jambs && share_beside(opening, opening.jambs.a) >= options_.min_beside_share &&
           share_beside(opening, opening.jambs.b) >= options_.min_beside_share;
  }

  const BuildingGrid& grid_;
  const OpeningOptions& options_;
  const double step_m_;
  std::vector<std::vector<CellStep>>
      rays_;  ///< from the left of each heading, turned by a half turn
};

/// Of chords that are near each other the narrowest decides: one opening or none.
std::vector<Doorway> one_a_place(std::vector<Chord> chords) {
  std::stable_sort(chords.begin(), chords.end(),
                   [](const Chord& a, const Chord& b) { return a.width_m < b.width_m; });
  PlaceIndex places;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    places.add(i, box_around(chords[i].opening.frame_from_pivot.position(), 0.0));
  }
  std::vector<Doorway> openings;
  std::vector<bool> is_taken(chords.size(), false);
  for (std::size_t first = 0; first < chords.size(); ++first) {
    if (is_taken[first]) continue;
    const Point2 place = chords[first].opening.frame_from_pivot.position();
    const Chord* best = nullptr;
    for (const std::size_t i : places.near(box_around(place, kOneOpeningM))) {
      const Chord& chord = chords[i];
      if (is_taken[i] || (chord.opening.frame_from_pivot.position() - place).norm() > kOneOpeningM)
        continue;
      is_taken[i] = true;
      const bool is_narrow = chord.width_m <= chords[first].width_m + kAsNarrowM;
      if (best == nullptr && chord.is_opening && is_narrow) best = &chord;
    }
    if (best == nullptr) continue;
    const auto near_best =
        places.near(box_around(best->opening.frame_from_pivot.position(), kSamePassageM));
    const bool is_beside_narrower = std::any_of(near_best.begin(), near_best.end(), [&](auto i) {
      const Chord& chord = chords[i];
      return chord.width_m < best->width_m - kAsNarrowM &&
             (chord.opening.frame_from_pivot.position() - best->opening.frame_from_pivot.position())
                     .norm() <= kSamePassageM;
    });
    if (!is_beside_narrower) openings.push_back(best->opening);
  }
  return openings;
}

}  // namespace

std::vector<Doorway> find_openings(const BuildingGrid& grid, const OpeningOptions& options) {
  const Chords chords(grid, options);
  const int reach_cells =
      static_cast<int>(std::ceil((options.max_width_m / 2.0 + kOffCenterM) / grid.frame.cell_m));
  const CellMask near_obstacle = dilated(grid.obstacle, reach_cells);
  std::vector<Chord> found;
  for_each_cell(grid.passable.domain, [&](const Cell& cell) {
    if (!grid.passable.at(cell) || !near_obstacle.at(cell)) return;
    if (const auto chord = chords.narrowest_at(cell)) found.push_back(*chord);
  });
  std::vector<Doorway> openings = one_a_place(std::move(found));
  for (Doorway& opening : openings) opening = chords.centered(opening);
  return openings;
}

Doorway with_jambs_at_peaks(const Doorway& opening, const ReflectionMap& map) {
  const Point2 middle = opening.frame_from_pivot.position();
  const Point2 across = direction(opening.frame_from_pivot.theta_rad);
  const double step_m = map.frame().cell_m / 2.0;
  const auto hits_at = [&](const Point2& at) {
    double hits = 0.0;
    for (double off_m = -kPeakBandM; off_m <= kPeakBandM; off_m += step_m) {
      hits += map.at(map.frame().cell_of(at + off_m * across)).hits;
    }
    return hits;
  };
  const auto peak_beyond = [&](const Point2& jamb) {
    const Point2 outward = (jamb - middle).normalized();
    const double first_m = (jamb - middle).norm();
    double best_m = first_m;
    double most = -1.0;
    for (double at_m = first_m; at_m <= first_m + kPeakReachM; at_m += step_m) {
      const double hits = hits_at(middle + at_m * outward);
      if (hits <= most) continue;
      most = hits;
      best_m = at_m;
    }
    double sum = 0.0;
    double weight = 0.0;
    for (int i = -2; i <= 2; ++i) {  // a cell and its neighbours, in half cells
      const double at_m = best_m + i * step_m;
      const double hits = hits_at(middle + at_m * outward);
      sum += hits * at_m;
      weight += hits;
    }
    return Point2(middle + (weight > 0.0 ? sum / weight : first_m) * outward);
  };
  return doorway_between({peak_beyond(opening.jambs.a), peak_beyond(opening.jambs.b)},
                         opening.frame_from_pivot.theta_rad);
}

}  // namespace roomatlas
