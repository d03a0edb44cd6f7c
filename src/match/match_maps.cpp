// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/match_maps.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

constexpr std::int8_t kOnFace = 100;     // what a point scores in a cell with a face ...
constexpr std::int8_t kBesideFace = 60;  // ... beside one: less asks for more than the raster tells
constexpr std::int8_t kOnFree = -30;  // ... where free space was seen: nearer to 0 lets rooms lie
                                      // on each other, farther forgives no moved furniture
constexpr int kMargin = 8;            // cells around the map: the largest square reaches 7 out
constexpr double kNoScore = -1e18;    // below any
// What no wall fixes can still be inverted; 1/m^2 and 1/rad^2.
constexpr double kLeastInformation = 1e-6;
constexpr double kWindowSigmas = 3.0;  // the window's rim counts as this many sigmas off the guess
constexpr double kPenalty = 0.5;       // of the score, which lies in [-30, 100], a square sigma

template <typename Point>
std::vector<Point> evenly(const std::vector<Point>& points, int count) {
  const double stride = std::max(1.0, static_cast<double>(points.size()) / count);
  std::vector<Point> some;
  for (double at = 0.0; at < static_cast<double>(points.size()); at += stride) {
    some.push_back(points[static_cast<std::size_t>(at)]);
  }
  return some;
}

/// The heading changes so little that the farthest point moves by about a cell.
double angle_step(const std::vector<ScanPoint>& points, double cell_m) {
  constexpr double kMinRad = radians(0.4);  // not finer, however small the cells
  constexpr double kNearM = 5.0;  // small rooms are turned as if they reached this far: not coarser
  constexpr double kFarM = 12.0;  // farther points may skip cells: a long corridor would take long
  double farthest_m = kNearM;
  for (const ScanPoint& point : points) farthest_m = std::max(farthest_m, point.position.norm());
  return std::max(kMinRad, cell_m / std::min(farthest_m, kFarM));
}

/// 0, 1, -1, 2, -2 ...: the likeliest first.
int nth_from_middle(int n) { return (n + 1) / 2 * (n % 2 == 1 ? 1 : -1); }

/// What a place off the guess costs; nothing where there is no window.
double penalty(double off, double reached) {
  const double sigmas = reached > 0.0 ? kWindowSigmas * off / reached : 0.0;
  return kPenalty * sigmas * sigmas;
}

}  // namespace

SearchableMap::SearchableMap(const LocalMap& map, const MatchMapsOptions& options)
    : map_(map), options_(options) {
  const CellBox inner = map.box();
  box_ = {{inner.min.x - kMargin, inner.min.y - kMargin},
          {inner.max.x + kMargin, inner.max.y + kMargin}};
  std::vector<std::int8_t> base(box_.count(), 0);
  map.for_each_known_cell(
      options.min_face_hits, [&](const Cell& cell) { base[box_.index_of(cell)] = kOnFree; },
      [&](const Cell& face) {
        for_each_cell({{face.x - 1, face.y - 1}, {face.x + 2, face.y + 2}}, [&](const Cell& cell) {
          std::int8_t& value = base[box_.index_of(cell)];
          value = std::max(value, cell == face ? kOnFace : kBesideFace);
        });
      });
  levels_.push_back(std::move(base));
  const auto width = static_cast<std::size_t>(box_.width());
  const auto height = static_cast<std::size_t>(box_.height());
  for (int level = 1; level < kLevels; ++level) {
    const std::size_t half = std::size_t{1} << (level - 1);
    const std::vector<std::int8_t>& below = levels_.back();
    std::vector<std::int8_t> row_maxima(below.size());
    std::vector<std::int8_t> maxima(below.size());
    const auto larger = [](std::int8_t a, std::int8_t b) { return std::max(a, b); };
    for (std::size_t y = 0; y < height; ++y) {
      const std::int8_t* from = &below[y * width];
      std::int8_t* to = &row_maxima[y * width];
      for (std::size_t x = 0; x + half < width; ++x) to[x] = larger(from[x], from[x + half]);
      for (std::size_t x = width - half; x < width; ++x) to[x] = larger(from[x], std::int8_t{0});
    }
    for (std::size_t y = 0; y < height; ++y) {
      const std::int8_t* from = &row_maxima[y * width];
      const std::int8_t* above = y + half < height ? &row_maxima[(y + half) * width] : nullptr;
      std::int8_t* to = &maxima[y * width];
      for (std::size_t x = 0; x < width; ++x) {
        to[x] = larger(from[x], above != nullptr ? above[x] : std::int8_t{0});
      }
    }
    levels_.push_back(std::move(maxima));
  }
}

double SearchableMap::score(int level, const std::vector<Cell>& cells, const Cell& shift) const {
  const std::int8_t* values = levels_[static_cast<std::size_t>(level)].data();
  const auto width = static_cast<unsigned>(box_.width());
  const auto height = static_cast<unsigned>(box_.height());
  const int left = shift.x - box_.min.x;
  const int low = shift.y - box_.min.y;
  int sum = 0;
  for (const Cell& cell : cells) {
    const auto x = static_cast<unsigned>(cell.x + left);
    const auto y = static_cast<unsigned>(cell.y + low);
    if (x < width && y < height) sum += values[static_cast<std::size_t>(y) * width + x];
  }
  return static_cast<double>(sum) / static_cast<double>(cells.size());
}

void SearchableMap::add_squares(int level, const CellBox& shifts, const std::vector<Cell>& cells,
                                std::vector<Candidate>& stack) const {
  const int side = 1 << level;
  for (int x = shifts.min.x; x < shifts.max.x; x += side) {
    for (int y = shifts.min.y; y < shifts.max.y; y += side) {
      stack.push_back({score(level, cells, {x, y}), {x, y}});
    }
  }
  std::stable_sort(stack.begin(), stack.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
}

void SearchableMap::search_shifts(const std::vector<Cell>& cells, const Turned& turned,
                                  const SearchWindow& window, Best& best) const {
  constexpr int kTop = kLevels - 1;  // the level of the largest squares
  const double cell_m = map_.frame().cell_m;
  const int reach = static_cast<int>(std::ceil(window.reach_m / cell_m));
  std::vector<std::vector<Candidate>> open(kLevels);  // one stack a level, best at the back
  add_squares(kTop, {{-reach, -reach}, {reach + 1, reach + 1}}, cells, open[kTop]);
  int level = kTop;
  while (level <= kTop) {
    auto& stack = open[static_cast<std::size_t>(level)];
    if (stack.empty()) {
      ++level;
      continue;
    }
    const Candidate candidate = stack.back();
    if (candidate.score <= best.score) {
      stack.clear();
      continue;
    }
    stack.pop_back();
    const Cell& shift = candidate.shift;
    if (level == 0) {
      const double off_m = std::hypot(shift.x, shift.y) * cell_m;
      const double value = candidate.score - penalty(off_m, window.reach_m) -
                           penalty(turned.by_rad, window.reach_rad);
      if (value <= best.score) continue;
      best = {{turned.pose.x_m + shift.x * cell_m, turned.pose.y_m + shift.y * cell_m,
               turned.pose.theta_rad},
              value};
      continue;
    }
    const int side = 1 << level;
    --level;
    add_squares(level,
                {shift, {std::min(shift.x + side, reach + 1), std::min(shift.y + side, reach + 1)}},
                cells, open[static_cast<std::size_t>(level)]);
  }
}

Pose2 SearchableMap::search(const std::vector<ScanPoint>& points, const Pose2& guess,
                            const SearchWindow& window) const {
  const double step_rad = angle_step(points, map_.frame().cell_m);
  const int turns = static_cast<int>(std::ceil(window.reach_rad / step_rad));
  Best best{guess, kNoScore};
  std::vector<Cell> cells(points.size());
  for (int n = 0; n <= 2 * turns; ++n) {
    const double turn_rad = nth_from_middle(n) * step_rad;
    const Pose2 turned{guess.x_m, guess.y_m, wrap_angle(guess.theta_rad + turn_rad)};
    const PointTransform place(turned);
    std::transform(points.begin(), points.end(), cells.begin(), [&](const ScanPoint& point) {
      return map_.frame().cell_of(place * point.position);
    });
    search_shifts(cells, {turned, turn_rad}, window, best);
  }
  return best.pose;
}

void SearchableMap::judge(const std::vector<ScanPoint>& points, MapMatch& match) const {
  const PointTransform place(match.first_from_second);
  const PointTransform turn(Pose2{0.0, 0.0, match.first_from_second.theta_rad});
  for (const ScanPoint& point : points) {
    const Point2 at = place * point.position;
    const Point2 normal = turn * point.normal;
    const Cell cell = map_.frame().cell_of(at);
    bool agrees = false;
    map_.for_each_face_near(at, options_.agree_m, [&](const Face& face) {
      const bool is_turned = normal.squaredNorm() > 0.0 && face.normal.squaredNorm() > 0.0 &&
                             face.normal.dot(normal) < options_.align.min_normal_cosine;
      agrees = agrees || (!is_turned && (face.position - at).norm() <= options_.agree_m);
    });
    if (agrees) {
      ++match.agreeing;
    } else if (map_.is_seen_free(cell)) {
      ++match.contradicting;
    } else {
      ++match.unseen;
    }
  }
}

MapMatch SearchableMap::find(const std::vector<ScanPoint>& points, const Pose2& guess,
                             const SearchWindow& window) const {
  MapMatch match;
  match.first_from_second = guess;
  if (points.empty()) return match;
  const Pose2 start = search(evenly(points, options_.searched_points), guess, window);
  const std::vector<ScanPoint> some = evenly(points, options_.aligned_points);
  const ScanAlignment aligned = align(map_, some, start, std::nullopt, options_.align);
  match.first_from_second = aligned.map_from_points;
  judge(some, match);
  const double all_over_some =
      static_cast<double>(points.size()) / static_cast<double>(some.size());
  const auto scaled = [&](int count) {
    return static_cast<int>(std::lround(count * all_over_some));
  };
  match.agreeing = scaled(match.agreeing);
  match.contradicting = scaled(match.contradicting);
  match.unseen = scaled(match.unseen);

  const double variance =
      options_.point_sigma_m * options_.point_sigma_m * options_.points_per_sample / all_over_some;
  const Eigen::Matrix3d information =
      aligned.hessian / variance + kLeastInformation * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d covariance = information.inverse();
  const double floor_m = options_.floor_position_m;
  const double floor_rad = radians(options_.floor_heading_deg);
  covariance.diagonal() +=
      Eigen::Vector3d(floor_m * floor_m, floor_m * floor_m, floor_rad * floor_rad);
  Eigen::Matrix3d second_from_first = Eigen::Matrix3d::Identity();  // axes only
  const Point2 x_axis = direction(aligned.map_from_points.theta_rad);
  second_from_first.topLeftCorner<2, 2>() << x_axis.x(), x_axis.y(), -x_axis.y(), x_axis.x();
  covariance = second_from_first * covariance * second_from_first.transpose();
  match.information = covariance.inverse();
  match.information = (match.information + match.information.transpose().eval()) / 2.0;
  return match;
}

std::vector<ScanPoint> points_of(const LocalMap& map, const MatchMapsOptions& options) {
  std::vector<ScanPoint> points;
  for (const Face& face : map.faces(options.min_face_hits)) {
    points.push_back({face.position, face.normal, true});
  }
  return points;
}

}  // namespace roomatlas
