// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draft/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "column_candidates.hpp"

namespace roomatlas {
namespace {

constexpr int kRoundCorners = 16;  // of a circle as drawn

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

/// Which of them stand in rows.
class Rows {
 public:
  Rows(const std::vector<Column>& columns, const ColumnOptions& options)
      : columns_(columns), options_(options), is_in_row_(columns.size(), false) {
    for (std::size_t a = 0; a < columns.size(); ++a) {
      for (std::size_t middle = 0; middle < columns.size(); ++middle) add_row(a, middle);
    }
    const std::vector<bool> rows = is_in_row_;
    for (std::size_t one = 0; one < columns.size(); ++one) {
      if (rows[one]) add_parallel_rows(rows, one);
    }
  }

  [[nodiscard]] bool has(std::size_t column) const { return is_in_row_[column]; }

 private:
  /// One like another that stands off it as given, if there is one.
  [[nodiscard]] std::optional<std::size_t> one_at(std::size_t from, const Point2& step) const {
    for (std::size_t to = 0; to < columns_.size(); ++to) {
      const Point2 off = columns_[to].middle - columns_[from].middle - step;
      if (off.norm() < 2.0 * options_.spacing_m &&
          are_alike(columns_[from], columns_[to], options_))
        return to;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool are_apart(const Point2& step) const {
    return step.norm() >= options_.nearest_m && step.norm() <= options_.farthest_m;
  }

  /// Three at even distances, the way that their sides run.
  void add_row(std::size_t a, std::size_t middle) {
    const Point2 step = columns_[middle].middle - columns_[a].middle;
    if (!are_apart(step) || !are_alike(columns_[a], columns_[middle], options_)) return;
    const auto b = one_at(middle, step);
    if (!b) return;
    const std::array<std::size_t, 3> row = {a, middle, *b};
    if (!std::all_of(row.begin(), row.end(),
                     [&](std::size_t one) { return runs_along(step, columns_[one], options_); })) {
      return;
    }
    for (const std::size_t one : row) is_in_row_[one] = true;
  }

  /// Those that stand beside one of a row as others stand beside others of it: a row of which some
  /// are hidden.
  void add_parallel_rows(const std::vector<bool>& rows, std::size_t known) {
    for (std::size_t beside = 0; beside < columns_.size(); ++beside) {
      const Point2 step = columns_[beside].middle - columns_[known].middle;
      if (rows[beside] || !are_apart(step) ||
          !are_alike(columns_[known], columns_[beside], options_)) {
        continue;
      }
      for (std::size_t other = 0; other < columns_.size(); ++other) {
        if (!rows[other] || other == known || !one_at(other, step)) continue;
        is_in_row_[beside] = true;
        break;
      }
    }
  }

  const std::vector<Column>& columns_;
  const ColumnOptions& options_;
  std::vector<bool> is_in_row_;
};

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
  const std::vector<Column> columns = column_candidates(pieces, surfaces, options);
  const Rows rows(columns, options);
  std::vector<Ring> outlines;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (rows.has(i)) outlines.push_back(outline_of(columns[i]));
  }
  return outlines;
}

}  // namespace roomatlas
