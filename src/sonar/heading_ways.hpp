// SPDX-License-Identifier: GPL-3.0-or-later
// The likeliest ways of the heading beside another one: Viterbi's passes (Viterbi 1967) over the
// states of the heading's chain, unwrapped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "roomatlas/odometry/heading_chain.hpp"

namespace roomatlas {

/// States beside a reference heading: directions of the building one after the other, in each how
/// far a way is beyond the reference, from a little below it to a little above a quarter turn.
class StatesBeside {
 public:
  /// @param reference_rad correction of the heading by node, unwrapped
  /// @param sign of the quarter turn, 1 or -1
  StatesBeside(const HeadingChain& chain, const std::vector<double>& reference_rad, int sign);

  [[nodiscard]] std::size_t size() const { return directions_ * row(); }
  [[nodiscard]] std::size_t row() const {
    return static_cast<std::size_t>(quarter_ + 2 * margin_ + 1);
  }
  /// In steps of the chain, towards the quarter turn.
  [[nodiscard]] int beyond(std::size_t state) const {
    return static_cast<int>(state % row()) - margin_;
  }
  /// Whether nearer to the reference's winding than to the other.
  [[nodiscard]] bool is_near(std::size_t state) const { return 2 * beyond(state) < quarter_; }
  [[nodiscard]] int quarter() const { return quarter_; }
  [[nodiscard]] int sign() const { return sign_; }
  /// Steps by which the reference itself moves towards the quarter turn.
  [[nodiscard]] int drift(std::size_t from_node, std::size_t to_node) const {
    return sign_ * (reference_[to_node] - reference_[from_node]);
  }
  /// Place of a state in the chain's beliefs.
  [[nodiscard]] std::size_t belief_at(std::size_t node, std::size_t state) const;

 private:
  int sign_;
  int margin_;
  int quarter_;
  std::size_t corrections_;
  std::size_t directions_;
  std::vector<int> reference_;  ///< in steps
};

/// The likeliest ways from one end of the mission to each state of each node.
struct HeadingWays {
  std::vector<std::vector<double>> log_odds;    ///< by node and state
  std::vector<std::vector<std::int32_t>> from;  ///< the state before, seen from that end
};

/// Ways from the first node, where they are near the reference, to each node.
[[nodiscard]] HeadingWays ways_until(const HeadingChain& chain, const StatesBeside& states);

/// Ways from each node to the last, where they are near the other winding.
[[nodiscard]] HeadingWays ways_since(const HeadingChain& chain, const StatesBeside& states);

}  // namespace roomatlas
