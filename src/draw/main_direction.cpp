// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas {
namespace {

constexpr double kRightAngle = kPi / 2.0;
constexpr int kBins = 180;                 // of half a degree
constexpr int kSmooth = 3;                 // bins to each side that count for a peak
constexpr double kNearlyMost = 0.75;       // of the strongest peak: another one that may be chosen
constexpr double kNear_rad = 0.0524;       // 3 degrees: an edge so near follows the direction
constexpr double kLeastShare = 1.0 / 3.0;  // of all edges; fewer are no direction
constexpr double kNoTurn_rad = 1e-4;       // less cannot be seen on a sheet: 0.1 mm in 1 m
constexpr double kBlockShare = 0.6;        // of a room's edges, for a direction of its own
constexpr double kRectangle = 0.85;        // of its box that a room fills to be called a rectangle

template <typename Visit>
void for_each_edge(const PlanRoom& room, Visit visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 edge = ring[(i + 1) % ring.size()] - ring[i];
      const double length_m = edge.norm();
      if (length_m > 0.0 && edge.allFinite()) {
        visit(wrap_quarter(std::atan2(edge.y(), edge.x())), length_m);
      }
    }
  };
  for (const Polygon& part : room.parts) {
    visit_ring(part.outer);
    for (const Ring& hole : part.holes) visit_ring(hole);
  }
}

/// The bin with most length in and around it; of bins with nearly as much, the one nearest to the
/// axes, so that a building with two wings stands as its coordinates do.
int peak_of(const std::array<double, kBins>& bins) {
  std::array<double, kBins> sums{};
  for (int i = 0; i < kBins; ++i) {
    for (int k = -kSmooth; k <= kSmooth; ++k) {
      sums[static_cast<std::size_t>(i)] +=
          bins[static_cast<std::size_t>((i + k + kBins) % kBins)] * (kSmooth + 1 - std::abs(k));
    }
  }
  const double most = *std::max_element(sums.begin(), sums.end());
  constexpr int kAxis = kBins / 2;
  int best = -1;
  for (int i = 0; i < kBins; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool is_peak = sums[at] >= sums[static_cast<std::size_t>((i + 1) % kBins)] &&
                         sums[at] >= sums[static_cast<std::size_t>((i + kBins - 1) % kBins)];
    if (!is_peak || sums[at] < kNearlyMost * most) continue;
    if (best < 0 || std::abs(i - kAxis) < std::abs(best - kAxis)) best = i;
  }
  return std::max(best, 0);
}

/// The mean direction of the edges near `start_rad`, and their share of all length.
struct Direction {
  double angle_rad = 0.0;
  double share = 0.0;
};

Direction refined(const std::vector<const PlanRoom*>& rooms, double start_rad) {
  double all_m = 0.0;
  double near_m = 0.0;
  double sum = 0.0;
  for (const PlanRoom* room : rooms) {
    for_each_edge(*room, [&](double angle_rad, double length_m) {
      all_m += length_m;
      const double off_rad = wrap_quarter(angle_rad - start_rad);
      if (std::abs(off_rad) > kNear_rad) return;
      near_m += length_m;
      sum += off_rad * length_m;
    });
  }
  if (near_m == 0.0) return {};
  return {wrap_quarter(start_rad + sum / near_m), near_m / all_m};
}

Direction direction_of(const std::vector<const PlanRoom*>& rooms) {
  std::array<double, kBins> bins{};
  for (const PlanRoom* room : rooms) {
    for_each_edge(*room, [&](double angle_rad, double length_m) {
      const double share = (angle_rad + kRightAngle / 2.0) / kRightAngle;
      bins[static_cast<std::size_t>(std::clamp(static_cast<int>(share * kBins), 0, kBins - 1))] +=
          length_m;
    });
  }
  const double start_rad = ((peak_of(bins) + 0.5) / kBins - 0.5) * kRightAngle;
  return refined(rooms, refined(rooms, start_rad).angle_rad);
}

}  // namespace

double main_direction_rad(const FloorPlan& plan) {
  std::vector<const PlanRoom*> rooms;
  for (const PlanRoom& room : plan.rooms) rooms.push_back(&room);
  const Direction found = direction_of(rooms);
  const bool is_one = found.share >= kLeastShare && std::abs(found.angle_rad) > kNoTurn_rad;
  return is_one ? found.angle_rad : 0.0;
}

std::vector<const PlanRoom*> main_block(const FloorPlan& plan, double direction_rad) {
  std::vector<const PlanRoom*> block;
  for (const PlanRoom& room : plan.rooms) {
    const Direction own = direction_of({&room});
    const bool is_aside = own.share >= kBlockShare &&
                          std::abs(wrap_quarter(own.angle_rad - direction_rad)) > 2.0 * kNear_rad;
    if (!is_aside) block.push_back(&room);
  }
  if (!block.empty()) return block;
  for (const PlanRoom& room : plan.rooms) block.push_back(&room);
  return block;
}

std::optional<RoomExtent> extent_of(const PlanRoom& room, double direction_rad) {
  if (room.parts.empty()) return std::nullopt;
  const Direction own = direction_of({&room});
  const double turn_rad = own.share >= kBlockShare ? own.angle_rad : direction_rad;
  const Pose2 frame_from_building{0.0, 0.0, -turn_rad};
  const Ring outer = transformed(frame_from_building, room.parts.front().outer);
  const Point2 size = bounds(outer).size();
  if (std::abs(signed_area(outer)) < kRectangle * size.prod()) return std::nullopt;
  const bool is_swapped = std::abs(wrap_angle(turn_rad - direction_rad)) > kPi / 4.0;
  return is_swapped ? RoomExtent{size.y(), size.x()} : RoomExtent{size.x(), size.y()};
}

}  // namespace roomatlas
