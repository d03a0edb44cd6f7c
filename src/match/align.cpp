// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/match/align.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas {
namespace {

constexpr double kCloseM = 0.05;       // looked around first. It saves time and changes no partner
constexpr double kSettledShare = 0.6;  // of the iterations: by then the gate is at its smallest
constexpr double kNearlySettled = 1e-3;  // m and rad; after smaller steps the gate shrinks at once
constexpr double kSettled = 1e-5;        // m and rad; smaller steps end the iteration

/// The nearest face within the gate that looks the way the point does.
const Face* partner_of(const LocalMap& map, const Point2& at, const Point2& normal, double gate_m,
                       const AlignOptions& options) {
  const bool has_normal = normal.squaredNorm() > 0.0;
  const auto nearest_within = [&](double radius_m) {
    const Face* best = nullptr;
    double best_square = radius_m * radius_m;
    map.for_each_face_near(at, radius_m, [&](const Face& face) {
      const double square = (face.position - at).squaredNorm();
      if (square >= best_square) return;
      const bool is_turned = has_normal && face.normal.squaredNorm() > 0.0 &&
                             face.normal.dot(normal) < options.min_normal_cosine;
      if (is_turned) return;
      best_square = square;
      best = &face;
    });
    return best;
  };
  // most points have a partner close by: fewer cells to look into
  const Face* close = gate_m > kCloseM ? nearest_within(kCloseM) : nullptr;
  return close != nullptr ? close : nearest_within(gate_m);
}

/// Normal equations over x, y, theta.
struct Equations {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& jacobian, double residual, double weight) {
    hessian.noalias() += weight * jacobian * jacobian.transpose();
    gradient += weight * residual * jacobian;
  }
};

/// How the point moves with x, y and theta, along a direction.
Eigen::Vector3d jacobian_along(const Point2& along, const Point2& turned_point) {
  return {along.x(), along.y(), cross(turned_point, along)};
}

/// Along the face's normal. Where it has none it may be a corner, which holds the point in both
/// axes; or, far along a corridor, the end of what was seen of a wall, which must not: there the
/// point's own normal counts, or nothing.
void add_pair(const Face& face, const Point2& at, const Point2& turned_point,
              const Point2& turned_normal, const AlignOptions& options, Equations& equations) {
  const Point2 off = at - face.position;
  const double scale = options.robust_m * options.robust_m;
  const bool has_normal = face.normal.squaredNorm() > 0.0;
  if (!has_normal && options.corner_weight > 0.0) {
    const double weight = options.corner_weight / (1.0 + off.squaredNorm() / scale);
    equations.add(jacobian_along(Point2::UnitX(), turned_point), off.x(), weight);
    equations.add(jacobian_along(Point2::UnitY(), turned_point), off.y(), weight);
    return;
  }
  const Point2& normal = has_normal ? face.normal : turned_normal;
  if (normal.squaredNorm() == 0.0) return;
  const double residual = normal.dot(off);
  equations.add(jacobian_along(normal, turned_point), residual,
                1.0 / (1.0 + residual * residual / scale));
}

void add_prior(const PosePrior& prior, const Pose2& pose, const AlignOptions& options,
               Equations& equations) {
  const double variance = options.robust_m * options.robust_m;  // of one residual
  const double position = variance / (prior.position_sigma_m * prior.position_sigma_m);
  const double heading = variance / (prior.heading_sigma_rad * prior.heading_sigma_rad);
  equations.add(Eigen::Vector3d::UnitX(), pose.x_m - prior.mean.x_m, position);
  equations.add(Eigen::Vector3d::UnitY(), pose.y_m - prior.mean.y_m, position);
  equations.add(Eigen::Vector3d::UnitZ(), wrap_angle(pose.theta_rad - prior.mean.theta_rad),
                heading);
}

/// Every so many of the points that are hits, about `most` of them.
std::vector<Point2> some_hits(std::span<const ScanPoint> points, int most) {
  const auto hits =
      std::count_if(points.begin(), points.end(), [](const ScanPoint& p) { return p.is_hit; });
  const auto stride = std::max<std::ptrdiff_t>(1, hits / most);
  std::vector<Point2> some;
  std::ptrdiff_t seen = 0;
  for (const ScanPoint& point : points) {
    if (point.is_hit && seen++ % stride == 0) some.push_back(point.position);
  }
  return some;
}

/// The certainty under points, summed for each shift of a square window. Steps are shorter than
/// cells: a cell that several shifts of a point lead to is looked up once.
class ShiftedSums {
 public:
  ShiftedSums(const LocalMap& map, int steps, double step_m)
      : map_(map), steps_(steps), step_m_(step_m), side_(static_cast<std::size_t>(2 * steps + 1)) {
    columns_.resize(side_);
    rows_.resize(side_);
    column_.resize(side_);
  }

  void clear() { sums_.assign(side_ * side_, 0); }

  void add(const Point2& point) {
    for (std::size_t i = 0; i < side_; ++i) {
      const double shift_m = (static_cast<int>(i) - steps_) * step_m_;
      const Cell cell = map_.frame().cell_of(point + Point2(shift_m, shift_m));
      columns_[i] = cell.x;
      rows_[i] = cell.y;
    }
    for (std::size_t i = 0; i < side_; ++i) {
      if (i == 0 || columns_[i] != columns_[i - 1]) look_up(columns_[i]);
      for (std::size_t j = 0; j < side_; ++j) sums_[i * side_ + j] += column_[j];
    }
  }

  /// @param i, j steps along x and y, from minus to plus those given
  [[nodiscard]] int at(int i, int j) const {
    return sums_[static_cast<std::size_t>(i + steps_) * side_ +
                 static_cast<std::size_t>(j + steps_)];
  }

 private:
  void look_up(int x) {
    for (std::size_t j = 0; j < side_; ++j) {
      column_[j] = j > 0 && rows_[j] == rows_[j - 1] ? column_[j - 1]
                                                     : std::max(0, map_.certainty({x, rows_[j]}));
    }
  }

  const LocalMap& map_;
  int steps_;
  double step_m_;
  std::size_t side_;
  std::vector<int> columns_;  ///< of cells, by shift of the point being added
  std::vector<int> rows_;
  std::vector<int> column_;  ///< certainties of one column, by shift
  std::vector<int> sums_;
};

}  // namespace

ScanAlignment align(const LocalMap& map, std::span<const ScanPoint> points,
                    const Pose2& map_from_points, const std::optional<PosePrior>& prior,
                    const AlignOptions& options) {
  constexpr double kDamping = 1e-3;  // keeps directions that nothing fixes where they are
  ScanAlignment result;
  result.map_from_points = map_from_points;
  Pose2& pose = result.map_from_points;
  const double shrink = 1.0 / (kSettledShare * options.max_iterations);
  double shrunk = 0.0;  // of the way from the first gate to the last
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const double gate_m =
        options.first_gate_m + shrunk * (options.last_gate_m - options.first_gate_m);
    const Point2 cosine_sine = direction(pose.theta_rad);
    const auto turned = [&](const Point2& p) {
      return Point2(cosine_sine.x() * p.x() - cosine_sine.y() * p.y(),
                    cosine_sine.y() * p.x() + cosine_sine.x() * p.y());
    };
    Equations equations;
    result.points = 0;
    result.matched = 0;
    for (const ScanPoint& point : points) {
      if (!point.is_hit) continue;
      ++result.points;
      const Point2 arm = turned(point.position);
      const Point2 at = pose.position() + arm;
      const Point2 normal = turned(point.normal);
      const Face* face = partner_of(map, at, normal, gate_m, options);
      if (face == nullptr) continue;
      ++result.matched;
      add_pair(*face, at, arm, normal, options, equations);
    }
    result.hessian = equations.hessian;
    if (prior) add_prior(*prior, pose, options, equations);
    equations.hessian += kDamping * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = -equations.hessian.ldlt().solve(equations.gradient);
    if (!step.allFinite()) break;
    pose = {pose.x_m + step.x(), pose.y_m + step.y(), wrap_angle(pose.theta_rad + step.z())};
    if (shrunk >= 1.0 && step.norm() < kSettled) break;
    shrunk = step.norm() < kNearlySettled ? 1.0 : std::min(1.0, shrunk + shrink);
  }
  return result;
}

Pose2 correlate(const LocalMap& map, std::span<const ScanPoint> points, const PosePrior& prior,
                const CorrelateOptions& options) {
  const std::vector<Point2> used = some_hits(points, options.max_points);
  if (used.empty()) return prior.mean;
  const int steps = static_cast<int>(std::lround(options.reach_m / options.step_m));
  const int turns = static_cast<int>(std::lround(options.reach_rad / options.step_rad));
  const double most = HimmGrid::kMaxHalfSteps * static_cast<double>(used.size());
  const auto squared = [](double value) { return value * value; };
  ShiftedSums sums(map, steps, options.step_m);
  Pose2 best = prior.mean;
  double best_score = -1.0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const Pose2 turned{prior.mean.x_m, prior.mean.y_m,
                       wrap_angle(prior.mean.theta_rad + turn * options.step_rad)};
    sums.clear();
    const PointTransform place(turned);
    for (const Point2& p : used) sums.add(place * p);
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        const Point2 shift(i * options.step_m, j * options.step_m);
        const double score =
            sums.at(i, j) / most -
            options.penalty * (shift.squaredNorm() / squared(prior.position_sigma_m) +
                               squared(turn * options.step_rad / prior.heading_sigma_rad));
        if (score <= best_score) continue;
        best_score = score;
        best = {turned.x_m + shift.x(), turned.y_m + shift.y(), turned.theta_rad};
      }
    }
  }
  return best;
}

}  // namespace roomatlas
