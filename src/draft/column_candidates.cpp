// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_candidates.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

#include "roomatlas/core/median.hpp"
#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {
namespace {

constexpr double kAround_m = 0.2;        // surfaces this near a piece's outline are its own
constexpr double kSide_rad = kPi / 6.0;  // of a surface's normal from that of its side
constexpr std::size_t kFewest = 8;       // surfaces of a piece; fewer say nothing
constexpr double kCell_m = 0.02;         // between surfaces once they are thinned

/// A rectangle of which some sides were seen: how far they are from the origin, along normals that
/// begin with `along_rad` and turn left.
struct Sides {
  double along_rad = 0.0;
  std::array<std::optional<double>, 4> offset_m;
};

std::vector<const SurfacePoint*> surfaces_around(const Ring& outline,
                                                 const std::vector<SurfacePoint>& surfaces) {
  const Box2 box = bounds(outline);
  const Point2 middle = (box.min + box.max) / 2.0;
  const Point2 reach = box.size() / 2.0 + Point2::Constant(kAround_m);
  std::vector<const SurfacePoint*> around;
  for (const SurfacePoint& surface : surfaces) {
    const Point2 off = surface.at - middle;
    if ((off.cwiseAbs() - reach).maxCoeff() > 0.0) continue;
    // One that looks at the piece is of something beside it.
    if (off.dot(direction(surface.normal_rad)) <= 0.0) continue;
    if (distance_to_boundary(outline, surface.at) < kAround_m) around.push_back(&surface);
  }
  return around;
}

/// The sides of which enough was seen, each where half of its surfaces are before it and half
/// behind.
Sides sides_of(const std::vector<const SurfacePoint*>& around, double along_rad,
               const ColumnOptions& options) {
  Sides sides{along_rad, {}};
  for (std::size_t side = 0; side < 4; ++side) {
    const double normal_rad = along_rad + static_cast<double>(side) * kPi / 2.0;
    std::vector<double> offsets_m;
    for (const SurfacePoint* surface : around) {
      if (std::abs(wrap_angle(surface->normal_rad - normal_rad)) > kSide_rad) continue;
      offsets_m.push_back(surface->at.dot(direction(normal_rad)));
    }
    if (kCell_m * static_cast<double>(offsets_m.size()) < options.least_side_m) continue;
    sides.offset_m[side] = median(std::move(offsets_m));
  }
  return sides;
}

/// Where the two sides across a direction are: as seen, or one of them as far from the other as
/// `else_m` says. Nothing where that does not agree, or neither was seen.
std::optional<std::pair<double, double>> placed(const std::optional<double>& far_m,
                                                const std::optional<double>& near_m,
                                                const std::optional<double>& else_m,
                                                const ColumnOptions& options) {
  if (far_m && near_m) {
    const double seen_m = *far_m + *near_m;
    if (else_m && std::abs(seen_m - *else_m) > options.alike_m) return std::nullopt;
    return std::pair((*far_m - *near_m) / 2.0, seen_m);
  }
  if (!else_m || (!far_m && !near_m)) return std::nullopt;
  return std::pair(far_m ? *far_m - *else_m / 2.0 : *else_m / 2.0 - *near_m, *else_m);
}

/// The column with these sides; where one was not seen, as large as another is.
std::optional<Column> column_with(const Sides& sides, const std::optional<double>& length_m,
                                  const std::optional<double>& width_m,
                                  const ColumnOptions& options) {
  const auto along = placed(sides.offset_m[0], sides.offset_m[2], length_m, options);
  const auto across = placed(sides.offset_m[1], sides.offset_m[3], width_m, options);
  if (!along || !across) return std::nullopt;
  return Column{along->first * direction(sides.along_rad) +
                    across->first * direction(sides.along_rad + kPi / 2.0),
                sides.along_rad, along->second, across->second, false};
}

/// The circle on which surfaces lie and from whose middle they look away: at = middle + r normal,
/// by least squares.
std::optional<Column> circle(const std::vector<const SurfacePoint*>& around) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const SurfacePoint* surface : around) {
    const Point2 way = direction(surface->normal_rad);
    Eigen::Matrix<double, 2, 3> row;
    row << 1.0, 0.0, way.x(), 0.0, 1.0, way.y();
    normal += row.transpose() * row;
    right += row.transpose() * surface->at;
  }
  const Eigen::LDLT<Eigen::Matrix3d> solved(normal);
  if (solved.info() != Eigen::Success || solved.rcond() < 1e-6) return std::nullopt;
  const Eigen::Vector3d found = solved.solve(right);
  return Column{found.head<2>(), 0.0, 2.0 * found.z(), 2.0 * found.z(), true};
}

bool is_as_thick(const Column& column, const ColumnOptions& options) {
  return std::min(column.length_m, column.width_m) >= options.thinnest_m &&
         std::max(column.length_m, column.width_m) <= options.thickest_m;
}

/// Those that were seen from all sides, then those that were not and may be like one of them.
class Candidates {
 public:
  Candidates(const std::vector<PlanFurniture>& pieces, const std::vector<SurfacePoint>& surfaces,
             const ColumnOptions& options)
      : options_(options), main_rad_(surfaces.empty() ? 0.0 : main_direction_rad(surfaces)) {
    for (const PlanFurniture& piece : pieces) {
      if (is_as_large(piece)) add(surfaces_around(piece.outline.outer, surfaces));
    }
    const std::size_t whole = columns_.size();
    for (const Sides& sides : in_part_) {
      for (std::size_t like = 0; like < whole; ++like) {
        if (add_like(columns_[like], sides)) break;
      }
    }
  }

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

 private:
  [[nodiscard]] bool is_as_large(const PlanFurniture& piece) const {
    const double largest_m = std::sqrt(2.0) * options_.thickest_m + kAround_m;
    return piece.kind == FurnitureKind::free_standing &&
           bounds(piece.outline.outer).size().maxCoeff() <= largest_m;
  }

  /// What stands beside a column turns what was seen of it: the building's direction is better.
  [[nodiscard]] double regular(double along_rad) const {
    const double off_rad = wrap_angle(4.0 * (along_rad - main_rad_)) / 4.0;
    return std::abs(off_rad) < radians(options_.in_line_deg) ? along_rad - off_rad : along_rad;
  }

  void add(const std::vector<const SurfacePoint*>& around) {
    if (around.size() < kFewest) return;
    std::complex<double> sum;
    for (const SurfacePoint* surface : around) sum += std::polar(1.0, 4.0 * surface->normal_rad);
    const bool is_round = std::abs(sum) < options_.round_share * static_cast<double>(around.size());
    const Sides sides = sides_of(around, regular(std::arg(sum) / 4.0), options_);
    const auto column = is_round ? circle(around) : column_with(sides, {}, {}, options_);
    if (!column) {
      in_part_.push_back(sides);
    } else if (is_as_thick(*column, options_)) {
      columns_.push_back(*column);
    }
  }

  bool add_like(const Column& like, const Sides& sides) {
    if (like.is_round) return false;
    auto column = column_with(sides, like.length_m, like.width_m, options_);
    if (!column) column = column_with(sides, like.width_m, like.length_m, options_);
    if (column) columns_.push_back(*column);
    return column.has_value();
  }

  const ColumnOptions& options_;
  double main_rad_;  ///< of the building's walls
  std::vector<Column> columns_;
  std::vector<Sides> in_part_;
};

}  // namespace

std::vector<Column> column_candidates(const std::vector<PlanFurniture>& pieces,
                                      const std::vector<SurfacePoint>& surfaces,
                                      const ColumnOptions& options) {
  return Candidates(pieces, surfaces, options).columns();
}

}  // namespace roomatlas
