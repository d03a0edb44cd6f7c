// SPDX-License-Identifier: GPL-3.0-or-later
#include "explorer_doorways.hpp"

#include <array>

namespace roomatlas {
namespace {

constexpr double kMaxWidthM = 1.2;   // wider takes narrow corridors for doors
constexpr double kStepM = 0.05;      // a cell of the explorer's map
constexpr double kSeenM = 0.5;       // of free floor on both sides of the door line
constexpr double kWideningM = 0.4;   // how much wider than the door the space before it is
constexpr double kWideReachM = 1.2;  // to each side, how far that is measured ...
constexpr double kWideFromM = 0.35;  // ... from this far before the door line ...
constexpr double kWideToM = 0.8;     // ... to this far, ...
constexpr double kWideEveryM = 0.1;  // ... each two cells
constexpr double kJambM = 0.35;      // of wall beyond each jamb ...
constexpr double kWallShare = 0.5;   // ... so much must have been seen, ...
constexpr std::array kAcrossM = {0.0, -0.05, 0.05, -0.1, 0.1};  // ... within two cells of the line

bool is_free(const ExplorerMap& map, const Point2& point) {
  return map.himm().raw(map.frame().cell_of(point)) < 0;
}

/// How far the floor is free from a point.
double free_m(const ExplorerMap& map, const Point2& from, const Point2& along, double reach_m) {
  double at_m = 0.0;
  while (at_m < reach_m && is_free(map, from + at_m * along)) at_m += kStepM;
  return at_m;
}

/// Free width across the way at a distance before the door line, from the middle of the door.
double width_before_m(const ExplorerMap& map, const Point2& middle, const Point2& before) {
  const Point2 left(-before.y(), before.x());
  double widest_m = 0.0;
  for (double at_m = kWideFromM; at_m < kWideToM; at_m += kWideEveryM) {
    const Point2 at = middle + at_m * before;
    widest_m = std::max(widest_m,
                        free_m(map, at, left, kWideReachM) + free_m(map, at, -left, kWideReachM));
  }
  return widest_m;
}

/// Share of the wall that goes on from a jamb, away from the door.
double wall_share(const ExplorerMap& map, const Point2& jamb, const Point2& outwards) {
  const Point2 across(-outwards.y(), outwards.x());
  double samples = 0.0;
  double walls = 0.0;
  for (double at_m = kStepM; at_m <= kJambM; at_m += kStepM) {
    samples += 1.0;
    for (const double off_m : kAcrossM) {
      const Point2 at = jamb + at_m * outwards + off_m * across;
      if (!map.is_obstacle(map.frame().cell_of(at))) continue;
      walls += 1.0;
      break;
    }
  }
  return walls / samples;
}

}  // namespace

std::optional<Doorway> seen_doorway(const ExplorerMap& map, const Pose2& map_from_way) {
  DoorwayOptions options;
  options.max_width_m = kMaxWidthM;
  const auto doorway = find_doorway(map.himm(), map_from_way, options);
  if (!doorway) return std::nullopt;
  const Point2 middle = doorway->frame_from_pivot.position();
  const Point2 ahead = direction(doorway->frame_from_pivot.theta_rad);
  const Point2 left(-ahead.y(), ahead.x());
  const bool seen = free_m(map, middle, ahead, kSeenM) >= kSeenM &&
                    free_m(map, middle, -ahead, kSeenM) >= kSeenM &&
                    width_before_m(map, middle, -ahead) >= doorway->width_m + kWideningM &&
                    wall_share(map, doorway->jambs.a, left) >= kWallShare &&
                    wall_share(map, doorway->jambs.b, -left) >= kWallShare;
  return seen ? doorway : std::nullopt;
}

}  // namespace roomatlas
