// SPDX-License-Identifier: GPL-3.0-or-later
#include "straight_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

namespace roomatlas {
namespace {

constexpr double kBinAcross_m = 0.02;  // walls are known to a centimetre or two
constexpr double kSeenGap_m = 0.2;     // seen stretches of a face this near are one
constexpr double kMostPerBin = 20.0;   // beams in a bin beyond which more say nothing new
constexpr int kLineRefinements = 3;
// Of the mean normal from the face's: larger takes pieces of a curve for walls. Short faces have
// few normals.
constexpr double kMaxTurn_rad = 2.5 * kPi / 180.0;
constexpr double kMaxTurnOfShort_rad = 5.0 * kPi / 180.0;
constexpr double kLongRun_m = 1.0;
constexpr double kMaxSlope = 0.035;   // of the surfaces themselves along the face, 2 degrees
constexpr double kSlopeFrom_m = 0.8;  // shorter faces have no slope that can be told

/// A surface by its place across and along the lines of one direction.
struct Placed {
  double across_m = 0.0;
  double along_m = 0.0;
  double weight = 0.0;
  double turn_rad = 0.0;  ///< of its normal from the direction
  int column = 0;
};

struct Run {
  int bins = 0;
  int first = 0;  ///< column
  int last = 0;
};

/// What lies in one bin across (row) and along (column).
struct Cell {
  int row = 0;
  int column = 0;
  float weight = 0.0F;
};

struct ColumnWeight {
  int column = 0;
  double weight = 0.0;
};

/// Weights of surfaces in bins across (rows) and along (columns) of one direction. Kept are bins
/// that hold something, so that work follows what was seen and not how far apart it lies.
class RunSearch {
 public:
  RunSearch(const std::vector<SurfacePoint>& surfaces, double normal_rad, const RunOptions& options)
      : normal_rad_(normal_rad), options_(options) {
    half_rows_ = std::max(1, static_cast<int>(std::lround(options.half_band_m / kBinAcross_m)));
    place(surfaces);
    fill_cells();
    best_.reserve(rows_.size());
    for (const int row : rows_) best_.push_back(longest_at(row));
  }

  std::vector<WallFace> found() {
    std::vector<WallFace> faces;
    while (const auto place = best_place()) {
      const int row = rows_[*place];
      const Run run = best_[*place];
      WallFace face = face_of(row, run);
      if (face.support_m() >= options_.min_support_m && looks_straight(face, run)) {
        faces.push_back(face);
      }
      take_out(row, run, face.offset_m);
    }
    return faces;
  }

 private:
  void place(const std::vector<SurfacePoint>& surfaces) {
    const Point2 normal = direction(normal_rad_);
    const Point2 along = direction(normal_rad_ + kPi / 2.0);
    double low_u = std::numeric_limits<double>::infinity();
    double low_v = low_u;
    placed_.reserve(surfaces.size());
    for (const SurfacePoint& surface : surfaces) {
      const Placed placed{surface.at.dot(normal), surface.at.dot(along), surface.weight,
                          wrap_angle(surface.normal_rad - normal_rad_), 0};
      low_u = std::min(low_u, placed.across_m);
      low_v = std::min(low_v, placed.along_m);
      placed_.push_back(placed);
    }
    across0_m_ = low_u - 3.0 * kBinAcross_m;
    along0_m_ = low_v - options_.bin_along_m;
    for (Placed& one : placed_) {
      one.column = static_cast<int>((one.along_m - along0_m_) / options_.bin_along_m);
    }
    // In the order of columns, so that those of a run are together.
    std::stable_sort(placed_.begin(), placed_.end(),
                     [](const Placed& a, const Placed& b) { return a.column < b.column; });
  }

  [[nodiscard]] int row_of(double across_m) const {
    return static_cast<int>((across_m - across0_m_) / kBinAcross_m);
  }

  /// Bins that hold something, by row and column, and the rows whose band reaches one of them.
  void fill_cells() {
    std::vector<Cell> single;
    single.reserve(placed_.size());
    for (const Placed& one : placed_) {
      single.push_back({row_of(one.across_m), one.column, static_cast<float>(one.weight)});
    }
    std::stable_sort(single.begin(), single.end(), [](const Cell& a, const Cell& b) {
      return std::tie(a.row, a.column) < std::tie(b.row, b.column);
    });
    for (const Cell& one : single) {
      if (!cells_.empty() && cells_.back().row == one.row && cells_.back().column == one.column) {
        cells_.back().weight += one.weight;
        continue;
      }
      cells_.push_back(one);
      const int from = std::max(one.row - half_rows_, rows_.empty() ? 0 : rows_.back() + 1);
      for (int row = from; row <= one.row + half_rows_; ++row) rows_.push_back(row);
    }
  }

  /// The cells of rows `from` to `to`.
  [[nodiscard]] std::span<Cell> cells_between(int from, int to) {
    const auto is_before = [](const Cell& cell, int row) { return cell.row < row; };
    const auto first = std::lower_bound(cells_.begin(), cells_.end(), from, is_before);
    const auto end = std::lower_bound(first, cells_.end(), to + 1, is_before);
    return {first, end};
  }

  /// What a band holds in each of the columns `first` to `last` that hold something.
  std::vector<ColumnWeight> band_at(int row, int first, int last) {
    std::vector<ColumnWeight> single;
    for (const Cell& cell : cells_between(row - half_rows_, row + half_rows_)) {
      if (cell.column >= first && cell.column <= last) single.push_back({cell.column, cell.weight});
    }
    std::stable_sort(
        single.begin(), single.end(),
        [](const ColumnWeight& a, const ColumnWeight& b) { return a.column < b.column; });
    std::vector<ColumnWeight> sums;
    for (const ColumnWeight& one : single) {
      if (!sums.empty() && sums.back().column == one.column) {
        sums.back().weight += one.weight;
      } else {
        sums.push_back(one);
      }
    }
    return sums;
  }
  /// Columns of a band in which there is enough.
  std::vector<int> columns_at(int row, int first, int last) {
    std::vector<int> columns;
    for (const ColumnWeight& sum : band_at(row, first, last)) {
      if (sum.weight >= options_.min_hits) columns.push_back(sum.column);
    }
    return columns;
  }

  Run longest_at(int row) {
    const std::vector<int> columns = columns_at(row, 0, std::numeric_limits<int>::max());
    Run longest;
    for (const auto& [first, last] :
         runs_of(columns, static_cast<int>(options_.max_gap_m / options_.bin_along_m))) {
      const int bins = columns[last] - columns[first] + 1;
      if (bins > longest.bins) longest = {bins, columns[first], columns[last]};
    }
    return longest;
  }

  /// The place of the row with the longest run; of equal ones that with most in it.
  std::optional<std::size_t> best_place() {
    int longest = 0;
    for (const Run& run : best_) longest = std::max(longest, run.bins);
    if (longest * options_.bin_along_m < options_.min_support_m - 1e-9) return std::nullopt;
    std::optional<std::size_t> best;
    double most = -1.0;
    for (std::size_t place = 0; place < rows_.size(); ++place) {
      const Run& run = best_[place];
      if (run.bins != longest) continue;
      double weight = 0.0;
      for (const ColumnWeight& sum : band_at(rows_[place], run.first, run.last)) {
        weight += sum.weight;
      }
      if (weight > most) {
        most = weight;
        best = place;
      }
    }
    return best;
  }

  /// Visits the surfaces of a run within a distance of a line.
  template <typename Visit>
  void for_each_near(const Run& run, double across_m, double within_m, Visit visit) const {
    const auto first =
        std::lower_bound(placed_.begin(), placed_.end(), run.first,
                         [](const Placed& one, int column) { return one.column < column; });
    for (auto one = first; one != placed_.end() && one->column <= run.last; ++one) {
      if (std::abs(one->across_m - across_m) <= within_m) visit(*one);
    }
  }

  /// Weights that let each piece of the run speak alike.
  std::vector<double> balance_of(const Run& run, double across_m, double within_m) const {
    std::vector<double> sums(static_cast<std::size_t>(run.last - run.first) + 1, 0.0);
    for_each_near(run, across_m, within_m, [&](const Placed& one) {
      sums[static_cast<std::size_t>(one.column - run.first)] += one.weight;
    });
    for (double& sum : sums) sum = sum > 0.0 ? std::min(sum, kMostPerBin) / sum : 0.0;
    return sums;
  }

  /// The offset of the line through the run: a mean that forgets what is off it.
  double offset_of(int row, const Run& run) const {
    double offset_m = across0_m_ + (row + 0.5) * kBinAcross_m;
    double within_m = (half_rows_ + 0.5) * kBinAcross_m;
    for (int i = 0; i <= kLineRefinements; ++i) {
      const std::vector<double> balance = balance_of(run, offset_m, within_m);
      double sum = 0.0;
      double weights = 0.0;
      for_each_near(run, offset_m, within_m, [&](const Placed& one) {
        const double weight =
            one.weight * balance[static_cast<std::size_t>(one.column - run.first)];
        sum += weight * one.across_m;
        weights += weight;
      });
      if (weights > 0.0) offset_m = sum / weights;
      within_m = options_.half_band_m;
    }
    return offset_m;
  }

  WallFace face_of(int row, const Run& run) {
    WallFace face;
    face.normal_rad = normal_rad_;
    face.offset_m = offset_of(row, run);
    const std::vector<int> columns = columns_at(row, run.first, run.last);
    const int gap = std::max(1, static_cast<int>(kSeenGap_m / options_.bin_along_m));
    for (const auto& [first, last] : runs_of(columns, gap)) {
      face.seen.push_back({along0_m_ + columns[first] * options_.bin_along_m,
                           along0_m_ + (columns[last] + 1) * options_.bin_along_m});
    }
    return face;
  }

  [[nodiscard]] bool looks_straight(const WallFace& face, const Run& run) const {
    if (!options_.check_normals) return true;
    const std::vector<double> balance = balance_of(run, face.offset_m, options_.half_band_m);
    double weights = 0.0, turn = 0.0, u = 0.0, v = 0.0, vv = 0.0, uv = 0.0;
    for_each_near(run, face.offset_m, options_.half_band_m, [&](const Placed& one) {
      const double weight = one.weight * balance[static_cast<std::size_t>(one.column - run.first)];
      const double off_m = one.across_m - face.offset_m;
      const double on_m = one.along_m - face.low_m();
      weights += weight;
      turn += weight * one.turn_rad;
      u += weight * off_m;
      v += weight * on_m;
      vv += weight * on_m * on_m;
      uv += weight * off_m * on_m;
    });
    const double support_m = face.support_m();
    const double most = support_m >= kLongRun_m ? kMaxTurn_rad : kMaxTurnOfShort_rad;
    if (std::abs(turn / weights) > most) return false;
    const double spread = vv / weights - v * v / (weights * weights);
    const double slope = (uv / weights - u * v / (weights * weights)) / std::max(1e-9, spread);
    return support_m < kSlopeFrom_m || std::abs(slope) < kMaxSlope;
  }

  void take_out(int row, const Run& run, double offset_m) {
    const int middle = row_of(offset_m);
    const int reach = 2 * half_rows_ + 1;
    const auto clear = [&](int from, int to) {
      for (Cell& cell : cells_between(from, to)) {
        if (cell.column >= run.first && cell.column <= run.last) cell.weight = 0.0F;
      }
    };
    clear(middle - reach, middle + reach);
    clear(row - half_rows_, row + half_rows_);
    const int from = std::min(row, middle) - reach - half_rows_ - 1;
    const int to = std::max(row, middle) + reach + half_rows_ + 1;
    const auto first = std::lower_bound(rows_.begin(), rows_.end(), from);
    for (auto at = first; at != rows_.end() && *at <= to; ++at) {
      best_[static_cast<std::size_t>(at - rows_.begin())] = longest_at(*at);
    }
  }

  double normal_rad_;
  RunOptions options_;
  std::vector<Placed> placed_;
  double across0_m_ = 0.0;
  double along0_m_ = 0.0;
  int half_rows_ = 1;
  std::vector<Cell> cells_;
  std::vector<int> rows_;  ///< ascending
  std::vector<Run> best_;  ///< of each of them
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> runs_of(const std::vector<int>& sorted, int gap) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i > 0 && sorted[i] - sorted[i - 1] <= gap) {
      runs.back().second = i;
    } else {
      runs.emplace_back(i, i);
    }
  }
  return runs;
}

std::vector<SurfacePoint> looking(const std::vector<SurfacePoint>& surfaces, double normal_rad,
                                  double within_rad) {
  std::vector<SurfacePoint> that_way;
  for (const SurfacePoint& surface : surfaces) {
    if (std::abs(wrap_angle(surface.normal_rad - normal_rad)) < within_rad) {
      that_way.push_back(surface);
    }
  }
  return that_way;
}

std::vector<WallFace> straight_runs(const std::vector<SurfacePoint>& surfaces, double normal_rad,
                                    const RunOptions& options) {
  if (surfaces.empty()) return {};
  return RunSearch(surfaces, normal_rad, options).found();
}

}  // namespace roomatlas
