// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/polyline/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas {
namespace {

constexpr double kFar = 1e12;  // squared cells; beyond any box, and sums of two stay finite

/// The lower envelope of parabolas over one row or column of squared distances.
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

}  // namespace

Raster<float> distance_inside(const CellMask& mask) {
  // One ring of cells more, outside: they are not in the mask.
  const CellBox padded{{mask.box.min.x - 1, mask.box.min.y - 1},
                       {mask.box.max.x + 1, mask.box.max.y + 1}};
  Raster<double> squared(padded);
  const auto width = static_cast<std::size_t>(padded.width());
  const auto height = static_cast<std::size_t>(padded.height());
  for_each_cell(padded, [&](const Cell& cell) { squared[cell] = mask.at(cell) ? kFar : 0.0; });
  Envelope envelope(std::max(width, height));
  std::vector<double> line(height);
  for (std::size_t x = 0; x < width; ++x) {
    line.resize(height);
    for (std::size_t y = 0; y < height; ++y) line[y] = squared.values[y * width + x];
    envelope.transform(line);
    for (std::size_t y = 0; y < height; ++y) squared.values[y * width + x] = line[y];
  }
  for (std::size_t y = 0; y < height; ++y) {
    const auto row = squared.values.begin() + static_cast<std::ptrdiff_t>(y * width);
    line.assign(row, row + static_cast<std::ptrdiff_t>(width));
    envelope.transform(line);
    std::copy(line.begin(), line.end(), row);
  }
  Raster<float> distance(mask.box);
  for_each_cell(mask.box, [&](const Cell& cell) {
    distance[cell] = static_cast<float>(std::sqrt(squared[cell]));
  });
  return distance;
}

}  // namespace roomatlas
