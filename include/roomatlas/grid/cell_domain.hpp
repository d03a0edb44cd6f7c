// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "roomatlas/grid/cells.hpp"

namespace roomatlas {

/// The cells that a mask or a raster has values of, numbered row by row: a box, or, of a building
/// that is long and mostly empty, spans of cells in each row (`domain_of`). Memory then follows
/// the floor that was seen and not the box around it. Copies share their spans.
class CellDomain {
 public:
  /// Neighbouring cells of one row, [from, to).
  struct Span {
    int from = 0;
    int to = 0;
    std::size_t first = 0;  ///< number of the cell at `from`
    [[nodiscard]] bool operator==(const Span&) const = default;
  };
  static constexpr auto kNone = static_cast<std::size_t>(-1);

  CellDomain() = default;
  CellDomain(const CellBox& box) : bounds_(box) {}  // NOLINT: a box is a domain

  /// The spans of rows.
  /// @param first_row y of the first
  /// @param rows in each row spans from left to right that neither overlap nor touch; their numbers
  ///        are given here
  static CellDomain from_rows(int first_row, std::vector<std::vector<Span>> rows);

  /// The number of a cell, in [0, count()); kNone of one that does not belong to the domain.
  [[nodiscard]] std::size_t find(const Cell& cell) const {
    if (!bounds_.contains(cell)) return kNone;
    return rows_ == nullptr ? bounds_.index_of(cell) : rows_->find(cell, bounds_.min.y);
  }
  [[nodiscard]] bool contains(const Cell& cell) const { return find(cell) != kNone; }
  [[nodiscard]] std::size_t count() const {
    return rows_ == nullptr ? bounds_.count() : rows_->count;
  }
  /// The smallest box around all cells.
  [[nodiscard]] const CellBox& bounds() const { return bounds_; }
  /// Whether one of the four cells beside a cell of the domain does not belong to it.
  [[nodiscard]] bool is_at_rim(const Cell& cell) const {
    return !contains({cell.x + 1, cell.y}) || !contains({cell.x - 1, cell.y}) ||
           !contains({cell.x, cell.y + 1}) || !contains({cell.x, cell.y - 1});
  }
  /// The cells of the domain that lie in a box.
  [[nodiscard]] CellDomain within(const CellBox& box) const;
  /// The same cells: then they have the same numbers.
  [[nodiscard]] bool operator==(const CellDomain& other) const;

  /// Visits the spans of a row, from left to right: `visit(span)`.
  template <typename Visit>
  void for_each_span(int y, Visit visit) const {
    if (rows_ == nullptr) {
      if (bounds_.width() > 0 && y >= bounds_.min.y && y < bounds_.max.y) {
        visit(Span{bounds_.min.x, bounds_.max.x, bounds_.index_of({bounds_.min.x, y})});
      }
      return;
    }
    for (const Span& span : rows_->of(y, bounds_)) visit(span);
  }

 private:
  struct Rows {
    std::vector<std::size_t> begin;  ///< of each row's spans; one more than there are rows
    std::vector<Span> spans;
    std::size_t count = 0;  ///< of all cells

    [[nodiscard]] std::span<const Span> of(int y, const CellBox& bounds) const {
      if (y < bounds.min.y || y >= bounds.max.y) return {};
      const auto row = static_cast<std::size_t>(y - bounds.min.y);
      return std::span(spans).subspan(begin[row], begin[row + 1] - begin[row]);
    }
    [[nodiscard]] std::size_t find(const Cell& cell, int first_row) const {
      const auto row = static_cast<std::size_t>(cell.y - first_row);
      for (std::size_t i = begin[row]; i < begin[row + 1]; ++i) {  // few: rooms that lie abreast
        const Span& span = spans[i];
        if (cell.x < span.to) {
          return cell.x >= span.from ? span.first + static_cast<std::size_t>(cell.x - span.from)
                                     : kNone;
        }
      }
      return kNone;
    }
  };

  CellBox bounds_;
  std::shared_ptr<const Rows> rows_;  ///< none: all of the box
};

/// Visits the cells of a domain in the order of their numbers, row by row.
template <typename Visit>
void for_each_cell(const CellDomain& domain, Visit visit) {
  for (int y = domain.bounds().min.y; y < domain.bounds().max.y; ++y) {
    domain.for_each_span(y, [&](const CellDomain::Span& span) {
      for (int x = span.from; x < span.to; ++x) visit(Cell{x, y});
    });
  }
}

}  // namespace roomatlas
