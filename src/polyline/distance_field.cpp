// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace roomatlas {
namespace {

/// The lower envelope of parabolas over one row of squared distances.
class Envelope {
 public:
  explicit Envelope(std::size_t most) : at_(most), from_(most + 1) {}

  /// @param squared one value a cell, replaced by min over q of (p - q)^2 + squared[q]
  void transform(std::vector<double>& squared) {
    out_.resize(squared.size());
    build(squared);
    std::size_t k = 0;
    for (std::size_t p = 0; p < squared.size(); ++p) {
      while (from_[k + 1] < static_cast<double>(p)) ++k;
      const double off = static_cast<double>(p) - static_cast<double>(at_[k]);
      out_[p] = off * off + squared[at_[k]];
    }
    squared.swap(out_);
  }

 private:
  void build(const std::vector<double>& squared) {
    const auto lifted = [&](std::size_t q) {
      return squared[q] + static_cast<double>(q) * static_cast<double>(q);
    };
    std::size_t last = 0;
    at_[0] = 0;
    from_[0] = -std::numeric_limits<double>::infinity();
    from_[1] = std::numeric_limits<double>::infinity();
    for (std::size_t q = 1; q < squared.size(); ++q) {
      double meet = 0.0;
      while (true) {
        meet = (lifted(q) - lifted(at_[last])) / (2.0 * static_cast<double>(q - at_[last]));
        if (meet > from_[last]) break;
        --last;
      }
      at_[++last] = q;
      from_[last] = meet;
      from_[last + 1] = std::numeric_limits<double>::infinity();
    }
  }

  std::vector<std::size_t> at_;
  std::vector<double> from_;
  std::vector<double> out_;
};

/// For each cell the cells to the nearest one of its column that is not in the mask, 0 for those
/// that are not.
Raster<std::int32_t> along_columns(const CellMask& mask) {
  const CellBox& box = mask.domain.bounds();
  const auto columns = static_cast<std::size_t>(std::max(0, box.width()));
  Raster<std::int32_t> nearest(mask.domain);
  for (const bool is_up : {true, false}) {
    std::vector<std::int32_t> run(columns, 0);  // cells of the mask in a row, up to here
    std::vector<int> before(columns, -2);       // row of the last cell of the domain
    for (int row = 0; row < box.height(); ++row) {
      const int y = is_up ? box.min.y + row : box.max.y - 1 - row;
      mask.domain.for_each_span(y, [&](const CellDomain::Span& span) {
        for (int x = span.from; x < span.to; ++x) {
          const std::size_t index = span.first + static_cast<std::size_t>(x - span.from);
          const auto column = static_cast<std::size_t>(x - box.min.x);
          if (before[column] != row - 1) run[column] = 0;
          before[column] = row;
          run[column] = mask.bits[index] != 0 ? run[column] + 1 : 0;
          nearest.values[index] =
              is_up ? run[column] : std::min(nearest.values[index], run[column]);
        }
      });
    }
  }
  return nearest;
}

}  // namespace

Raster<float> distance_inside(const CellMask& mask) {
  const Raster<std::int32_t> in_column = along_columns(mask);
  Raster<float> distance(mask.domain);
  const CellBox& box = mask.domain.bounds();
  Envelope envelope(static_cast<std::size_t>(std::max(0, box.width())) + 2);
  std::vector<double> line;
  for (int y = box.min.y; y < box.max.y; ++y) {
    mask.domain.for_each_span(y, [&](const CellDomain::Span& span) {
      const auto length = static_cast<std::size_t>(span.to - span.from);
      line.assign(length + 2, 0.0);  // a cell more at both ends, beyond: it is not in the mask
      for (std::size_t i = 0; i < length; ++i) {
        const double cells = in_column.values[span.first + i];
        line[i + 1] = cells * cells;
      }
      envelope.transform(line);
      for (std::size_t i = 0; i < length; ++i) {
        distance.values[span.first + i] = static_cast<float>(std::sqrt(line[i + 1]));
      }
    });
  }
  return distance;
}

}  // namespace roomatlas
