// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/columns.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>

namespace roomatlas {
namespace {

constexpr double kAround_m = 0.2;        // surfaces this near a piece's outline are its own
constexpr double kSide_rad = kPi / 6.0;  // of a surface's normal from that of its side
constexpr int kRoundCorners = 16;        // of a circle as drawn
constexpr double kCell_m = 0.02;         // between surfaces once they are thinned

/// What may be a column.
struct Column {
  Point2 middle = Point2::Zero();
  double along_rad = 0.0;  ///< of a side
  double length_m = 0.0;   ///< along that; a round one's diameter
  double width_m = 0.0;
  bool is_round = false;
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

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Four sides, each where half of its surfaces are before it and half behind.
std::optional<Column> rectangle(const std::vector<const SurfacePoint*>& around, double along_rad,
                                const ColumnOptions& options) {
  std::array<std::vector<double>, 4> offsets_m;
  for (const SurfacePoint* surface : around) {
    for (std::size_t side = 0; side < 4; ++side) {
      const double normal_rad = along_rad + static_cast<double>(side) * kPi / 2.0;
      if (std::abs(wrap_angle(surface->normal_rad - normal_rad)) > kSide_rad) continue;
      offsets_m[side].push_back(surface->at.dot(direction(normal_rad)));
    }
  }
  std::array<double, 4> offset_m{};
  for (std::size_t side = 0; side < 4; ++side) {
    if (offsets_m[side].empty()) return std::nullopt;
    offset_m[side] = median(offsets_m[side]);
  }
  Column column;
  column.along_rad = along_rad;
  column.length_m = offset_m[0] + offset_m[2];
  column.width_m = offset_m[1] + offset_m[3];
  for (std::size_t side = 0; side < 4; ++side) {
    const double side_m = side % 2 == 0 ? column.width_m : column.length_m;
    const double seen_m = kCell_m * static_cast<double>(offsets_m[side].size());
    if (seen_m < options.side_share * side_m) return std::nullopt;
  }
  column.middle = (offset_m[0] - offset_m[2]) / 2.0 * direction(along_rad) +
                  (offset_m[1] - offset_m[3]) / 2.0 * direction(along_rad + kPi / 2.0);
  return column;
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

std::optional<Column> column_of(const PlanFurniture& piece,
                                const std::vector<SurfacePoint>& surfaces,
                                const ColumnOptions& options) {
  const Box2 box = bounds(piece.outline.outer);
  const double largest_m = std::sqrt(2.0) * options.thickest_m + kAround_m;
  if (piece.kind != FurnitureKind::free_standing || box.size().maxCoeff() > largest_m) {
    return std::nullopt;
  }
  const auto around = surfaces_around(piece.outline.outer, surfaces);
  std::complex<double> sum;
  for (const SurfacePoint* surface : around) sum += std::polar(1.0, 4.0 * surface->normal_rad);
  if (around.size() < 4) return std::nullopt;
  const bool is_round = std::abs(sum) < options.round_share * static_cast<double>(around.size());
  const auto column = is_round ? circle(around) : rectangle(around, std::arg(sum) / 4.0, options);
  if (!column || std::min(column->length_m, column->width_m) < options.thinnest_m ||
      std::max(column->length_m, column->width_m) > options.thickest_m) {
    return std::nullopt;
  }
  return column;
}

/// Whether a row runs along one of a column's sides.
bool runs_along(const Point2& row, const Column& column, const ColumnOptions& options) {
  if (column.is_round) return true;
  const double off_rad = 4.0 * (std::atan2(row.y(), row.x()) - column.along_rad);
  return std::abs(wrap_angle(off_rad)) < 4.0 * radians(options.in_line_deg);
}

bool are_alike(const Column& a, const Column& b, const ColumnOptions& options) {
  const auto sizes = [](const Column& one) { return std::minmax(one.length_m, one.width_m); };
  const auto [a_low, a_high] = sizes(a);
  const auto [b_low, b_high] = sizes(b);
  return a.is_round == b.is_round && std::abs(a_low - b_low) < options.alike_m &&
         std::abs(a_high - b_high) < options.alike_m;
}

/// Those that stand in rows.
std::vector<bool> in_rows(const std::vector<Column>& columns, const ColumnOptions& options) {
  std::vector<bool> is_in_row(columns.size(), false);
  for (std::size_t middle = 0; middle < columns.size(); ++middle) {
    for (std::size_t a = 0; a < columns.size(); ++a) {
      const Point2 step = columns[middle].middle - columns[a].middle;
      if (step.norm() < options.nearest_m || step.norm() > options.farthest_m) continue;
      if (!are_alike(columns[a], columns[middle], options)) continue;
      for (std::size_t b = a + 1; b < columns.size(); ++b) {
        const Point2 expected = columns[middle].middle + step;
        if ((columns[b].middle - expected).norm() > 2.0 * options.spacing_m ||
            !are_alike(columns[b], columns[middle], options)) {
          continue;
        }
        const std::array<std::size_t, 3> row = {a, middle, b};
        if (!std::all_of(row.begin(), row.end(), [&](std::size_t one) {
              return runs_along(step, columns[one], options);
            })) {
          continue;
        }
        for (const std::size_t one : row) is_in_row[one] = true;
      }
    }
  }
  return is_in_row;
}

Ring outline_of(const Column& column) {
  Ring ring;
  if (column.is_round) {
    for (int i = 0; i < kRoundCorners; ++i) {
      ring.push_back(column.middle +
                     column.length_m / 2.0 * direction(2.0 * kPi * (i + 0.5) / kRoundCorners));
    }
    return ring;
  }
  const Point2 along = column.length_m / 2.0 * direction(column.along_rad);
  const Point2 across = column.width_m / 2.0 * direction(column.along_rad + kPi / 2.0);
  return {column.middle - along - across, column.middle + along - across,
          column.middle + along + across, column.middle - along + across};
}

}  // namespace

std::vector<Ring> find_columns(const std::vector<PlanFurniture>& pieces,
                               const std::vector<SurfacePoint>& surfaces,
                               const ColumnOptions& options) {
  std::vector<Column> columns;
  for (const PlanFurniture& piece : pieces) {
    if (const auto column = column_of(piece, surfaces, options)) columns.push_back(*column);
  }
  const std::vector<bool> is_column = in_rows(columns, options);
  std::vector<Ring> outlines;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (is_column[i]) outlines.push_back(outline_of(columns[i]));
  }
  return outlines;
}

}  // namespace roomatlas
