// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gauss_newton.hpp"
#include "roomatlas/solve/optimize.hpp"
#include "spanning_tree.hpp"

namespace roomatlas {

struct Solved {
  SlotPoses state;
  double chi_square = -1.0;  ///< weighted
  int iterations = 0;        ///< of all starts together
  bool converged = false;
  std::int32_t singular_node = -1;  ///< where the system is singular: nothing holds this node
  double other_minimum = -1.0;      ///< where several starts end differently: the worst end
  std::string message;
};

/// Solves one pose graph again and again, under weights that change: structure and memory are
/// kept. Weights are one an edge of `graph()`, or empty: all 1.
class LeastSquares {
 public:
  LeastSquares(const PoseGraph& poses, const OptimizeOptions& options);

  [[nodiscard]] const SolverGraph& graph() const { return graph_; }
  [[nodiscard]] const Incidence& incidence() const { return incidence_; }
  [[nodiscard]] GaussNewton& block_solver() { return *block_; }
  /// Over all edges at the guess, or without one along odometry.
  [[nodiscard]] double initial_chi_square() const { return initial_chi_square_; }

  /// The minimum without a start.
  [[nodiscard]] Solved solve(std::span<const double> weights);
  /// The minimum near a start.
  [[nodiscard]] Solved solve_from(const SlotPoses& start, std::span<const double> weights);
  /// Poses along odometry, as far as it leads, then over loops.
  [[nodiscard]] SlotPoses odometry() const;
  /// Loops without which odometry and trusted edges would not join each component: one choice.
  [[nodiscard]] std::vector<std::int32_t> bridges() const;

  [[nodiscard]] SlotPoses state_of(const std::vector<Pose2>& poses) const;
  /// In the frame of the guess: the fixed node of each component is where the guess has it.
  [[nodiscard]] std::vector<Pose2> poses_of(const SlotPoses& state) const;

 private:
  Solved by_block(const SlotPoses& start, std::span<const double> weights, StepSource source,
                  int max_iterations);
  Solved local(const SlotPoses& start, std::span<const double> weights, StepSource source);
  void try_more_starts(Solved& best, const SpanningTree& tree, bool from_guess,
                       std::span<const double> weights);
  Solved solve_with_losses(std::span<const double> weights);
  [[nodiscard]] SpanningTree odometry_tree() const;
  [[nodiscard]] bool is_good(double chi_square, std::span<const double> weights) const;
  void find_frames();
  void settle_headings();
  void continue_with_ceres(Solved& solved, const SlotPoses& start, std::span<const double> weights);

  const PoseGraph& poses_;
  OptimizeOptions options_;
  SolverGraph graph_;
  Incidence incidence_;
  std::optional<GaussNewton> block_;
  bool has_losses_ = false;
  /// Where the frame of a state lies in that of the poses, for each component: at its fixed node,
  /// turned with it unless measured headings turn the component.
  std::vector<Pose2> frames_;
  SlotPoses guess_;                   ///< empty where there is none
  double initial_chi_square_ = -1.0;  ///< at the guess, else along odometry; negative: not computed
};

}  // namespace roomatlas
