// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "closure_distance.hpp"

namespace roomatlas {

/// Accepts closures one after the other, from odometry on, the least ambiguous first. Odometry
/// predicts what joins two moments soon after each other well; a closure that passes where a false
/// one would hardly pass by chance is accepted, with that the prediction of the others sharpens,
/// and so on. Where only ambiguous ones are left, the one is accepted that most others bear out.
/// Accepted ones are tested again in each round, against all others, and may fall.
class ClosureGrowth {
 public:
  ClosureGrowth(const PoseGraph& poses, LeastSquares& squares);

  void run();

  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  [[nodiscard]] const Solved& solved() const { return solved_; }
  [[nodiscard]] const Issues& issues() const { return issues_; }

 private:
  /// A closure that lost against another although others bore it out too.
  struct Rival {
    std::int32_t edge = 0;
    std::size_t supporters = 0;
    std::size_t against = 0;
  };

  void grow();
  [[nodiscard]] bool has_long_tails() const;
  void widen();
  void warn();
  void solve_and_test();
  void estimate_noise();
  [[nodiscard]] double log_chance(const ClosureTest& test, double distance) const;
  [[nodiscard]] bool fits(const ClosureTest& test) const;
  [[nodiscard]] bool is_sharp(const ClosureTest& test) const;
  [[nodiscard]] bool is_accepted(const ClosureTest& test) const;
  bool drop_misfits();
  bool accept_sharp();
  bool accept_best_supported();
  [[nodiscard]] std::vector<std::size_t> supporters_of(std::size_t hypothesis);
  void accept(const ClosureTest& test);

  const PoseGraph& poses_;
  LeastSquares& squares_;
  std::vector<double> weights_;
  std::vector<int> drops_;  ///< how often each edge was dropped
  Solved solved_;
  std::vector<ClosureTest> tests_;
  double noise_variance_ = 1.0;  ///< times what the information matrices say
  double log_search_volume_ = 0.0;
  bool wide_ = false;  ///< the last stage, with the wide gate
  std::vector<Rival> rivals_;
  Issues issues_;
};

}  // namespace roomatlas
