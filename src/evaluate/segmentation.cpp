// SPDX-License-Identifier: GPL-3.0-or-later
#include "segmentation.hpp"

#include <algorithm>
#include <cmath>

#include "detection_score.hpp"

namespace roomatlas {
namespace {

/// The correlation of two yes-or-no answers (B. W. Matthews 1975), from the areas where they agree
/// and differ. Where one answer is the same everywhere it has no value: 1 if nothing differs,
/// else 0.
double matthews(double both, double found_only, double true_only, double neither) {
  const double product =
      (both + found_only) * (both + true_only) * (neither + found_only) * (neither + true_only);
  if (product > 0.0) return (both * neither - found_only * true_only) / std::sqrt(product);
  return found_only + true_only > 0.0 ? 0.0 : 1.0;
}

/// Sums over one side of the overlaps.
struct Shares {
  double area_m2 = 0.0;
  double shared_m2 = 0.0;
  double largest_m2 = 0.0;
  double largest_share_sum = 0.0;

  void add(double area, double shared, double largest) {
    area_m2 += area;
    shared_m2 += shared;
    largest_m2 += largest;
    largest_share_sum += ratio(largest, area);
  }
};

/// Whether two or more pieces are each a large share of the whole.
bool in_pieces(double whole_m2, const std::vector<double>& pieces_m2, double share) {
  return std::count_if(pieces_m2.begin(), pieces_m2.end(),
                       [&](double piece) { return piece >= share * whole_m2; }) > 1;
}

std::vector<double> column(const Overlaps& overlaps, std::size_t true_room) {
  std::vector<double> values;
  for (const auto& row : overlaps.shared_m2) values.push_back(row[true_room]);
  return values;
}

/// A found room is merged when it holds the larger part of two true rooms, or when two true rooms
/// are a large share of it.
bool merged(const Overlaps& overlaps, std::size_t room, double share) {
  const std::vector<double>& row = overlaps.shared_m2[room];
  std::int64_t swallowed = 0;
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (row[j] > 0.5 * overlaps.true_rooms[j].area_m2) ++swallowed;
  }
  return swallowed > 1 || in_pieces(overlaps.rooms[room].area_m2, row, share);
}

double mean_matthews(const Overlaps& overlaps, double all_m2,
                     const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  double sum = 0.0;
  for (const auto& [room, true_room] : pairs) {
    const double both = overlaps.shared_m2[room][true_room];
    const double found_only = std::max(overlaps.rooms[room].area_m2 - both, 0.0);
    const double true_only = std::max(overlaps.true_rooms[true_room].area_m2 - both, 0.0);
    sum += matthews(both, found_only, true_only,
                    std::max(all_m2 - both - found_only - true_only, 0.0));
  }
  return ratio(sum, static_cast<double>(overlaps.true_rooms.size()));
}

}  // namespace

Segmentation segmentation_of(const FloorPlan& plan, const FloorPlan& truth,
                             const Overlaps& overlaps,
                             const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                             double piece_share) {
  Segmentation result;
  Shares found;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    found.add(overlaps.rooms[i].area_m2, overlaps.shared_of_room_m2(i),
              overlaps.largest_of_room_m2(i));
    if (merged(overlaps, i, piece_share)) result.merged_rooms.push_back(plan.rooms[i].id);
  }
  Shares wanted;
  for (std::size_t j = 0; j < truth.rooms.size(); ++j) {
    const double area_m2 = overlaps.true_rooms[j].area_m2;
    wanted.add(area_m2, overlaps.shared_of_true_room_m2(j), overlaps.largest_of_true_room_m2(j));
    if (in_pieces(area_m2, column(overlaps, j), piece_share)) {
      result.split_true_rooms.push_back(truth.rooms[j].id);
    }
  }
  result.area_precision = ratio(found.largest_share_sum, static_cast<double>(plan.rooms.size()));
  result.area_recall = ratio(wanted.largest_share_sum, static_cast<double>(truth.rooms.size()));
  result.unlabelled = std::clamp(1.0 - ratio(wanted.shared_m2, wanted.area_m2), 0.0, 1.0);
  result.invented = std::clamp(1.0 - ratio(found.shared_m2, found.area_m2), 0.0, 1.0);
  result.over_segmentation = ratio(wanted.shared_m2 - wanted.largest_m2, wanted.shared_m2);
  result.under_segmentation = ratio(found.shared_m2 - found.largest_m2, found.shared_m2);
  result.matthews =
      mean_matthews(overlaps, found.area_m2 + wanted.area_m2 - wanted.shared_m2, pairs);
  return result;
}

}  // namespace roomatlas
