// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/plan_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "roomatlas/core/rigid_fit.hpp"
#include "room_raster.hpp"
#include "roomatlas/evaluate/assignment.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kStartPoints = 600;   ///< of the plan, that a start is judged by
constexpr std::size_t kClimbPoints = 4000;  ///< of the plan, that each step of climbing looks at
constexpr std::size_t kBestStarts = 20;     ///< that are refined
constexpr double kFirstStepM = 0.8;         ///< of climbing; halved until ...
constexpr double kLastStepM = 0.04;         ///< ... below this, half a cell of the lattice or so
constexpr double kTurnDegPerM = 5.0;        ///< a turn moves what is 11 m from the middle as far

/// Both plans as lattices.
struct Lattices {
  RoomRaster plan;
  RoomRaster truth;
};

/// [room][true room]: the share of both that they share, counted on every stride-th point.
WeightTable overlaps_at(const Lattices& lattices, const Pose2& truth_from_building,
                        std::size_t stride) {
  WeightTable iou;
  std::size_t at = 0;
  for (const auto& points : lattices.plan.points()) {
    std::vector<double>& row = iou.emplace_back(lattices.truth.rooms(), 0.0);
    double taken = 0.0;
    for (const Point2& point : points) {
      if (at++ % stride != 0) continue;
      taken += 1.0;
      const int room = lattices.truth.room_at(truth_from_building * point);
      if (room >= 0) row[static_cast<std::size_t>(room)] += 1.0;
    }
    for (std::size_t j = 0; j < row.size(); ++j) {
      const double true_points =
          static_cast<double>(lattices.truth.points()[j].size()) / static_cast<double>(stride);
      if (row[j] > 0.0) row[j] /= std::max(taken + true_points - row[j], row[j]);
    }
  }
  return iou;
}

struct Pairing {
  double iou_sum = 0.0;
  std::vector<PointPair> pulls;  ///< centres of paired rooms, in building and truth
};

Pairing pair_at(const Lattices& lattices, const Pose2& truth_from_building, double min_iou,
                std::size_t stride = 1) {
  const WeightTable iou = overlaps_at(lattices, truth_from_building, stride);
  const auto partner = best_assignment(iou);
  Pairing pairing;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (!partner[i]) continue;
    const double overlap = iou[i][*partner[i]];
    pairing.iou_sum += overlap;
    if (overlap < min_iou) continue;
    pairing.pulls.push_back({centre_of(lattices.plan.points()[i]),
                             centre_of(lattices.truth.points()[*partner[i]]), overlap});
  }
  return pairing;
}

/// A quick judgement: each room's best overlap, added up.
double judge_start(const Lattices& lattices, const Pose2& start, std::size_t stride) {
  double sum = 0.0;
  for (const auto& row : overlaps_at(lattices, start, stride)) {
    sum += row.empty() ? 0.0 : *std::max_element(row.begin(), row.end());
  }
  return sum;
}

std::vector<Point2> all_points(const RoomRaster& raster) {
  std::vector<Point2> all;
  for (const auto& points : raster.points()) all.insert(all.end(), points.begin(), points.end());
  return all;
}

/// Both plans' centres on each other, in every direction.
std::vector<Pose2> turned_starts(const Lattices& lattices, int rotations) {
  const Point2 from = centre_of(all_points(lattices.plan));
  const Point2 to = centre_of(all_points(lattices.truth));
  std::vector<Pose2> starts;
  for (int i = 0; i < rotations; ++i) {
    const Pose2 turn{0.0, 0.0, wrap_angle(2.0 * kPi * i / rotations)};
    const Point2 shift = to - turn * from;
    starts.push_back({shift.x(), shift.y(), turn.theta_rad});
  }
  return starts;
}

/// The centres of rooms, largest room first.
std::vector<Point2> centres_by_size(const RoomRaster& raster) {
  std::vector<std::vector<Point2>> rooms = raster.points();
  std::stable_sort(rooms.begin(), rooms.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  std::vector<Point2> centres;
  for (const auto& room : rooms) {
    if (!room.empty()) centres.push_back(centre_of(room));
  }
  return centres;
}

/// Pairs of large rooms laid on pairs of true rooms that are as far apart.
std::vector<Pose2> anchored_starts(const Lattices& lattices, const PlanAlignOptions& options) {
  std::vector<Point2> ours = centres_by_size(lattices.plan);
  ours.resize(std::min(ours.size(), static_cast<std::size_t>(options.anchor_rooms)));
  const std::vector<Point2> theirs = centres_by_size(lattices.truth);
  std::vector<Pose2> starts;
  for (std::size_t a = 0; a < ours.size(); ++a) {
    for (std::size_t b = a + 1; b < ours.size(); ++b) {
      const double gap_m = (ours[a] - ours[b]).norm();
      for (const Point2& first : theirs) {
        for (const Point2& second : theirs) {
          if (&first == &second) continue;
          if (std::abs((first - second).norm() - gap_m) > options.anchor_gap_m) continue;
          starts.push_back(rigid_fit({{ours[a], first}, {ours[b], second}}));
        }
      }
    }
  }
  return starts;
}

/// Matches and moves in turn, as long as the overlap grows.
PlanAlignment refined(const Lattices& lattices, Pose2 pose, const PlanAlignOptions& options) {
  PlanAlignment best;
  for (int round = 0; round < options.max_rounds; ++round) {
    const Pairing pairing = pair_at(lattices, pose, options.min_iou);
    const double overlap = pairing.iou_sum / static_cast<double>(lattices.truth.rooms());
    if (overlap <= best.overlap) break;
    best = {pose, AlignedBy::room_centroids, static_cast<int>(pairing.pulls.size()), overlap};
    if (pairing.pulls.size() < 2) break;
    pose = rigid_fit(pairing.pulls);
  }
  return best;
}

/// Moves and turns in ever smaller steps as long as the overlap grows: centres of rooms that were
/// seen in part had pulled it off.
PlanAlignment climbed(const Lattices& lattices, PlanAlignment best, std::size_t stride,
                      const PlanAlignOptions& options) {
  const auto overlap_of = [&](const Pose2& pose) {
    return pair_at(lattices, pose, options.min_iou, stride).iou_sum;
  };
  const Point2 middle = centre_of(all_points(lattices.plan));
  const Pose2 about{middle.x(), middle.y(), 0.0};  // turns are about the plan's middle
  double top = overlap_of(best.truth_from_building);
  for (double step_m = kFirstStepM; step_m > kLastStepM; step_m /= 2.0) {
    const double turn_rad = radians(step_m * kTurnDegPerM);
    for (bool moved = true; moved;) {
      moved = false;
      for (const Pose2& step :
           {Pose2{step_m, 0, 0}, Pose2{-step_m, 0, 0}, Pose2{0, step_m, 0}, Pose2{0, -step_m, 0},
            Pose2{0, 0, turn_rad}, Pose2{0, 0, -turn_rad}}) {
        const Pose2 tried = best.truth_from_building * about * step * inverse(about);
        const double overlap = overlap_of(tried);
        if (overlap <= top) continue;
        top = overlap;
        best.truth_from_building = tried;
        moved = true;
      }
    }
  }
  const Pairing pairing = pair_at(lattices, best.truth_from_building, options.min_iou);
  best.rooms = static_cast<int>(pairing.pulls.size());
  best.overlap = pairing.iou_sum / static_cast<double>(lattices.truth.rooms());
  return best;
}

}  // namespace

const char* to_string(AlignedBy by) {
  switch (by) {
    case AlignedBy::trajectory:
      return "trajectory";
    case AlignedBy::room_centroids:
      return "room centroids";
    case AlignedBy::nothing:
      break;
  }
  return "nothing";
}

PlanAlignment align_plan(const FloorPlan& plan, const FloorPlan& truth,
                         const PlanAlignOptions& options) {
  const Lattices lattices{RoomRaster(plan, options.lattice_m),
                          RoomRaster(truth, options.lattice_m)};
  const std::size_t points = all_points(lattices.plan).size();
  if (points == 0 || all_points(lattices.truth).empty()) return {};
  std::vector<Pose2> starts = turned_starts(lattices, options.start_rotations);
  for (const Pose2& start : anchored_starts(lattices, options)) starts.push_back(start);

  const std::size_t stride = std::max<std::size_t>(1, points / kStartPoints);
  std::vector<double> judged;
  judged.reserve(starts.size());
  for (const Pose2& start : starts) judged.push_back(judge_start(lattices, start, stride));
  std::vector<std::size_t> order(starts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return judged[a] > judged[b]; });

  PlanAlignment best;
  for (std::size_t i = 0; i < std::min(order.size(), kBestStarts); ++i) {
    PlanAlignment aligned = refined(lattices, starts[order[i]], options);
    if (aligned.by == AlignedBy::nothing) continue;
    aligned = climbed(lattices, aligned, std::max<std::size_t>(1, points / kClimbPoints), options);
    if (aligned.overlap > best.overlap) best = aligned;
  }
  return best;
}

}  // namespace roomatlas
