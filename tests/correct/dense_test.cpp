// SPDX-License-Identifier: GPL-3.0-or-later
// The correction of three ASRs, solved again by plain dense Gauss-Newton: numeric derivatives,
// robust loss by iterated weights, residuals written with poses instead of matrices.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "correct/corrected.hpp"
#include "roomatlas/core/pose2.hpp"
#include "support/numeric_derivative.hpp"

namespace roomatlas {
namespace {

using Eigen::VectorXd;

struct Block {
  test::VectorFunction error;  ///< of the state, divided by its standard deviations
  bool is_robust = false;
};

struct Solution {
  VectorXd state;
  double cost = 0.0;
};

/// Minimises the sum of rho(|error|^2) / 2, with rho Cauchy's or the identity.
Solution gauss_newton(const std::vector<Block>& blocks, VectorXd state, double robust_sigmas) {
  const double scale = robust_sigmas * robust_sigmas;
  for (int iteration = 0; iteration < 300; ++iteration) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(state.size(), state.size());
    VectorXd gradient = VectorXd::Zero(state.size());
    for (const Block& block : blocks) {
      const VectorXd error = block.error(state);
      const Eigen::MatrixXd jacobian = test::numeric_jacobian(block.error, state);
      const double weight = block.is_robust ? 1.0 / (1.0 + error.squaredNorm() / scale) : 1.0;
      normal += weight * jacobian.transpose() * jacobian;
      gradient += weight * jacobian.transpose() * error;
    }
    state -= normal.ldlt().solve(gradient);
  }
  Solution solution{state, 0.0};
  for (const Block& block : blocks) {
    const double squared = block.error(state).squaredNorm();
    solution.cost += 0.5 * (block.is_robust ? scale * std::log1p(squared / scale) : squared);
  }
  return solution;
}

/// There and back again, all a little off: 6 m ahead, then back to where it began, 0.3 m beside.
/// The third ASR begins at the doorway at which the first began. Walls contradict odometry.
struct ThereAndBack {
  Pose2 one = test::pose_deg(2, 1, 5);
  Pose2 one_from_two = test::pose_deg(6, 0.2, 44);
  Pose2 two_from_three = test::pose_deg(-4.1, 4.6, 131);
  double doorway_turn = -kPi;
  std::vector<double> walls_deg = {0, 48, 3};  ///< in the frame of each ASR

  [[nodiscard]] std::vector<Asr> asrs() const {
    const Pose2 two = one * one_from_two;
    auto chain = test::chain_mission({{{}, one}, {{}, two}, {{}, two * two_from_three}});
    for (std::size_t i = 0; i < 3; ++i) {
      const Polyline wall = {{0, 0}, {8, 0}, {8, 5}};
      chain[i].walls = {{transformed({0, 0, radians(walls_deg[i])}, wall), {true, true}}};
    }
    return chain;
  }
};

/// Standard deviations that depend neither on the way driven nor on the length of walls.
CorrectOptions constant_sigmas(CorrectionModel model) {
  CorrectOptions options = test::options_of(model);
  options.odometry = {.position = {.still = 0.15}, .heading = {.still = radians(3.0)}};
  options.doorway_position_m = 0.1;
  options.doorway_heading_deg = 6.0;
  options.wall_heading_deg = 2.0;
  options.wall_heading_deg_m = 0.0;
  options.robust_sigmas = 1.5;
  options.settle_on_walls = false;  // is no part of what is solved
  return options;
}

/// What both models share: headings of the three and the building's direction.
using Headings = std::function<double(const VectorXd&, int)>;

void add_walls(std::vector<Block>& blocks, const ThereAndBack& world, const Headings& heading,
               const CorrectOptions& options) {
  for (int i = 0; i < 3; ++i) {
    const double wall_rad = radians(world.walls_deg[static_cast<std::size_t>(i)]);
    const auto error = [=](const VectorXd& state) -> VectorXd {
      const double apart = heading(state, i) + wall_rad - state(state.size() - 1);
      return VectorXd::Constant(1, wrap_quarter(apart) / radians(options.wall_heading_deg));
    };
    blocks.push_back({error, true});
  }
}

void expect_same_as_solution(const Correction& correction, const Solution& solution,
                             const std::vector<Pose2>& poses) {
  EXPECT_TRUE(correction.converged) << correction.message;
  EXPECT_NEAR(correction.final_cost, solution.cost, 1e-6 * solution.cost);
  EXPECT_GT(solution.cost, 0.1) << "the measurements should contradict each other";
  const Pose2 one = correction.asrs[0].building_from_asr;
  const double direction = solution.state(solution.state.size() - 1);
  EXPECT_NEAR(one.theta_rad, wrap_angle(poses[0].theta_rad - direction), 1e-4);
  for (std::size_t i = 1; i < 3; ++i) {
    const Pose2 found = inverse(one) * correction.asrs[i].building_from_asr;
    const Pose2 expected = inverse(poses[0]) * poses[i];
    EXPECT_LT((found.position() - expected.position()).norm(), 1e-3) << "ASR " << i + 1;
    EXPECT_NEAR(wrap_angle(found.theta_rad - expected.theta_rad), 0.0, 1e-4) << "ASR " << i + 1;
  }
}

TEST(DenseGaussNewton, AgreesOnPosesThatTurnAndMove) {
  const ThereAndBack world;
  const auto options = constant_sigmas(CorrectionModel::se2);
  const auto pose = [=](const VectorXd& state, int i) {
    if (i == 0) return world.one;
    return Pose2{state(3 * i - 3), state(3 * i - 2), state(3 * i - 1)};
  };
  const auto relative = [=](int i, int j, const Pose2& i_from_j, double position_m, double deg) {
    return [=](const VectorXd& state) -> VectorXd {
      const Pose2 error = inverse(i_from_j) * (inverse(pose(state, i)) * pose(state, j));
      return Eigen::Vector3d(error.x_m / position_m, error.y_m / position_m,
                             wrap_angle(error.theta_rad) / radians(deg));
    };
  };
  std::vector<Block> blocks = {
      {relative(0, 1, world.one_from_two, 0.15, 3.0), false},
      {relative(1, 2, world.two_from_three, 0.15, 3.0), false},
      {relative(0, 2, {0, 0, world.doorway_turn}, 0.1, 6.0), true},
  };
  add_walls(
      blocks, world, [=](const VectorXd& s, int i) { return pose(s, i).theta_rad; }, options);

  const Pose2 two = world.one * world.one_from_two;
  const Pose2 three = two * world.two_from_three;
  VectorXd start(7);
  start << two.x_m, two.y_m, two.theta_rad, three.x_m, three.y_m, three.theta_rad, radians(5.0);
  const Solution solution = gauss_newton(blocks, start, options.robust_sigmas);
  expect_same_as_solution(
      test::corrected(world.asrs(), options, {test::same_doorway(1, 3, world.doorway_turn)}),
      solution, {world.one, pose(solution.state, 1), pose(solution.state, 2)});
}

TEST(DenseGaussNewton, AgreesOnRotationsAlone) {
  const ThereAndBack world;
  const auto options = constant_sigmas(CorrectionModel::rotation_only);
  const auto heading = [=](const VectorXd& state, int i) {
    return i == 0 ? world.one.theta_rad : state(i - 1);
  };
  const auto poses = [=](const VectorXd& state) {
    std::vector<Pose2> chain = {world.one};
    for (const Pose2& step : {world.one_from_two, world.two_from_three}) {
      const int i = static_cast<int>(chain.size());
      const Point2 pivot = chain.back() * step.position();
      chain.push_back({pivot.x(), pivot.y(), heading(state, i)});
    }
    return chain;
  };
  const auto relative = [=](int i, int j, double measured_rad, double deg) {
    return [=](const VectorXd& state) -> VectorXd {
      const double error = wrap_angle(heading(state, j) - heading(state, i) - measured_rad);
      return VectorXd::Constant(1, error / radians(deg));
    };
  };
  const auto closing = [=](const VectorXd& state) -> VectorXd {
    const auto chain = poses(state);
    return (chain[2].position() - chain[0].position()) / (0.15 * std::sqrt(2.0));  // two steps
  };
  std::vector<Block> blocks = {{relative(0, 1, world.one_from_two.theta_rad, 3.0), false},
                               {relative(1, 2, world.two_from_three.theta_rad, 3.0), false},
                               {relative(0, 2, world.doorway_turn, 6.0), true},
                               {closing, true}};
  add_walls(blocks, world, heading, options);

  const double two_rad = world.one.theta_rad + world.one_from_two.theta_rad;
  const Eigen::Vector3d start(two_rad, two_rad + world.two_from_three.theta_rad, radians(5.0));
  const Solution solution = gauss_newton(blocks, start, options.robust_sigmas);
  expect_same_as_solution(
      test::corrected(world.asrs(), options, {test::same_doorway(1, 3, world.doorway_turn)}),
      solution, poses(solution.state));
}

}  // namespace
}  // namespace roomatlas
