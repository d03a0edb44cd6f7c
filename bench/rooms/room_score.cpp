// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_score.hpp"

#include <map>

#include "roomatlas/evaluate/assignment.hpp"

namespace roomatlas::bench {
namespace {

constexpr double kMinFoundM2 = 0.2499;  // smaller regions are no rooms

double f1(int pairs, int true_rooms, int found_rooms) {
  return true_rooms + found_rooms == 0 ? 1.0 : 2.0 * pairs / (true_rooms + found_rooms);
}

}  // namespace

RoomScore room_score(const Raster<std::int32_t>& found, const Raster<std::int32_t>& truth,
                     double cell_m) {
  std::map<std::int32_t, double> all_of_found;
  std::map<std::int32_t, double> in_truth_of_found;
  std::map<std::int32_t, double> all_of_truth;
  std::map<std::pair<std::int32_t, std::int32_t>, double> common;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    if (found.values[i] > 0) ++all_of_found[found.values[i]];
    if (truth.values[i] == 0) continue;
    ++all_of_truth[truth.values[i]];
    if (found.values[i] == 0) continue;
    ++in_truth_of_found[found.values[i]];
    ++common[{truth.values[i], found.values[i]}];
  }
  std::erase_if(all_of_found,
                [&](const auto& room) { return room.second * cell_m * cell_m < kMinFoundM2; });
  WeightTable iou;
  for (const auto& [room, cells] : all_of_truth) {
    std::vector<double>& row = iou.emplace_back();
    for (const auto& [other, all] : all_of_found) {
      const auto shared = common.find({room, other});
      const double both = shared == common.end() ? 0.0 : shared->second;
      row.push_back(both / (cells + in_truth_of_found[other] - both));
    }
  }
  RoomScore score;
  score.true_rooms = static_cast<int>(all_of_truth.size());
  score.found_rooms = static_cast<int>(all_of_found.size());
  const auto partner = best_assignment(iou);
  int half = 0;
  int three_quarters = 0;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (!partner[i]) continue;
    const double value = iou[i][*partner[i]];
    score.mean_iou += value / score.true_rooms;
    half += value >= 0.5 ? 1 : 0;
    three_quarters += value >= 0.75 ? 1 : 0;
  }
  score.f1_half = f1(half, score.true_rooms, score.found_rooms);
  score.f1_three_quarters = f1(three_quarters, score.true_rooms, score.found_rooms);
  return score;
}

}  // namespace roomatlas::bench
