// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_headings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomatlas/core/for_each_index.hpp"
#include "sonar_factors.hpp"
#include "wall_headings.hpp"
#include "wall_stretches.hpp"

namespace roomatlas {
namespace {

constexpr double kLeastSlopeM = 0.1;  // a radian: less says nothing of the heading
constexpr double kSigmaM = 0.06;      // of a range, and of where the wall is
constexpr double kShare = 0.2;        // of what a return would say alone: neighbours say the same

/// What a return says of the heading: how much too long it is, and how that grows with a turn.
struct Evidence {
  double residual_m = 0.0;
  double slope_m_per_rad = 0.0;
};

/// The mean over all stretches of wall that the return may come from: mostly one wall, seen often.
std::optional<Evidence> evidence_of(const ConeReturn& heard, double half_cone_rad,
                                    const WallStretches& walls) {
  Evidence sum;
  int count = 0;
  walls.for_each_near(heard.sonar + heard.range_m * heard.axis,
                      [&](std::uint32_t, const WallStretch& wall) {
                        const auto expected_m = range_to_stretch(heard, half_cone_rad, wall);
                        if (!expected_m) return;
                        sum.residual_m += heard.range_m - *expected_m;
                        sum.slope_m_per_rad += range_by_heading(heard, half_cone_rad, wall.line);
                        ++count;
                      });
  if (count == 0) return std::nullopt;
  const Evidence mean{sum.residual_m / count, sum.slope_m_per_rad / count};
  if (std::abs(mean.slope_m_per_rad) < kLeastSlopeM) return std::nullopt;
  return mean;
}

struct NodeEvidence {
  std::size_t node = 0;
  Evidence evidence;
};

/// What the returns of one reading say.
void add_evidence(const RangeReading& reading, const Pose2& map_from_robot, std::size_t node,
                  const WallStretches& walls, std::vector<NodeEvidence>& found) {
  const RangeSensor& sensor = *reading.sensor;
  if (sensor.kind != SensorKind::sonar) return;
  const PointTransform place(map_from_robot);
  for (std::size_t beam = 0; beam < sensor.robot_from_beam.size(); ++beam) {
    const double range_m = reading.ranges_m[beam];
    if (!tells_of_walls(range_m, sensor)) continue;
    const Pose2 pose = place.pose(map_from_robot, sensor.robot_from_beam[beam]);
    const ConeReturn heard{pose.position(), pose.theta_rad, range_m};
    const auto evidence = evidence_of(heard, sensor.half_cone_rad, walls);
    if (evidence) found.push_back({node, *evidence});
  }
}

/// Least squares of the turns of all nodes: tridiagonal normal equations.
class Turns {
 public:
  explicit Turns(std::size_t nodes) : diagonal_(nodes, kHold), beside_(nodes), right_(nodes) {}

  void add(std::size_t node, const Evidence& evidence) {
    const double variance = kSigmaM * kSigmaM;
    const double chi = evidence.residual_m * evidence.residual_m / variance;
    const double weight = kShare / (variance * (1.0 + chi / kRobust));  // Cauchy's
    diagonal_[node] += weight * evidence.slope_m_per_rad * evidence.slope_m_per_rad;
    right_[node] += weight * evidence.slope_m_per_rad * evidence.residual_m;
  }
  /// What the batch knew of headings: it is at rest, so that this pulls back alone.
  void add_batch(const SonarBatch& batch, const SonarBatchOptions& options) {
    for (const SeenWall& wall : batch.walls) {
      diagonal_[wall.node] += heading_information(wall, options);
    }
    for (std::size_t k = 1; k < diagonal_.size(); ++k) {
      const double sigma = batch.steps[k].turn_sigma_rad;
      const double weight = 1.0 / (sigma * sigma);
      diagonal_[k - 1] += weight;
      diagonal_[k] += weight;
      beside_[k - 1] -= weight;
    }
  }
  [[nodiscard]] std::vector<double> solve() {
    const std::size_t nodes = diagonal_.size();
    for (std::size_t k = 1; k < nodes; ++k) {
      const double share = beside_[k - 1] / diagonal_[k - 1];
      diagonal_[k] -= share * beside_[k - 1];
      right_[k] -= share * right_[k - 1];
    }
    for (std::size_t k = nodes; k-- > 0;) {
      if (k + 1 < nodes) right_[k] -= beside_[k] * right_[k + 1];
      right_[k] /= diagonal_[k];
    }
    return right_;
  }

 private:
  static constexpr double kHold = 1e-3;   // 1/rad^2: where no wall holds a heading, it stays
  static constexpr double kRobust = 4.0;  // squared sigmas: returns off by more lose weight

  std::vector<double> diagonal_;
  std::vector<double> beside_;  ///< of each node with the next
  std::vector<double> right_;
};

}  // namespace

std::vector<Pose2> with_headings_of_returns(std::span<const RangeReading> readings,
                                            const SonarProblem& problem,
                                            std::span<const Pose2> map_from_robot,
                                            std::vector<Pose2> map_from_node,
                                            const SonarBatchOptions& options, int jobs) {
  const WallStretches walls(problem.batch.walls, map_from_node);
  Turns turns(map_from_node.size());
  turns.add_batch(problem.batch, options);
  constexpr std::size_t kBlock = 256;  // readings: enough work to be handed out
  const auto blocks = results_of<std::vector<NodeEvidence>>(
      (readings.size() + kBlock - 1) / kBlock, jobs, [&](std::size_t block) {
        std::vector<NodeEvidence> found;
        const std::size_t past = std::min(readings.size(), (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < past; ++i) {
          add_evidence(readings[i], map_from_robot[i], problem.node_of[i], walls, found);
        }
        return found;
      });
  for (const auto& block : blocks) {
    for (const NodeEvidence& one : block) turns.add(one.node, one.evidence);
  }
  const std::vector<double> turn_rad = turns.solve();
  for (std::size_t k = 0; k < map_from_node.size(); ++k) {
    map_from_node[k].theta_rad = wrap_angle(map_from_node[k].theta_rad + turn_rad[k]);
  }
  return map_from_node;
}

}  // namespace roomatlas
