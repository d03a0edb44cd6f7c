// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/odometry/heading_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace roomatlas {
namespace {

/// Five corrections in each of two directions, four nodes; drift to both sides, one node where
/// nothing was seen.
HeadingChain small_chain() {
  HeadingChain chain;
  chain.states = {5, 2};
  chain.switch_share = 0.1;
  chain.drift = {{},
                 {{1, 0.2}, {0, 0.6}, {-1, 0.2}},
                 {{2, 0.1}, {1, 0.2}, {0, 0.4}, {-1, 0.2}, {-2, 0.1}},
                 {{0, 0.8}, {1, 0.1}, {-1, 0.1}}};
  chain.evidence = {{0.9, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.2, 0.1, 0.3},
                    {0.2, 0.8, 0.1, 0.1, 0.3, 0.1, 0.2, 0.7, 0.4, 0.5},
                    {},
                    {0.1, 0.1, 0.6, 0.9, 0.2, 0.4, 0.1, 0.8, 0.3, 0.2}};
  return chain;
}

/// All sequences of states one after the other, each weighed as the chain's definition says.
class AllSequences {
 public:
  explicit AllSequences(HeadingChain chain) : chain_(std::move(chain)) {
    share_.assign(chain_.evidence.size(), std::vector<double>(chain_.states.size(), 0.0));
    std::vector<std::size_t> sequence;
    walk(sequence, 1.0);
  }
  [[nodiscard]] double evidence() const { return total_; }
  [[nodiscard]] double share(std::size_t node, std::size_t state) const {
    return share_[node][state] / total_;
  }

 private:
  [[nodiscard]] double moves(std::size_t node, std::size_t from, std::size_t to) const {
    const std::size_t count = chain_.states.corrections;
    if (node == 0 || chain_.drift[node].empty()) {
      return 1.0 / static_cast<double>(chain_.states.size());
    }
    double drifts = 0.0;
    for (const HeadingMove& move : chain_.drift[node]) {
      const auto reached = static_cast<int>(from % count) + move.steps + static_cast<int>(count);
      if (static_cast<std::size_t>(reached) % count == to % count) drifts += move.share;
    }
    const auto others = static_cast<double>(chain_.states.directions - 1);
    const bool stays = from / count == to / count;
    return drifts * (stays ? 1.0 - chain_.switch_share : chain_.switch_share / others);
  }
  void walk(std::vector<std::size_t>& sequence, double product) {
    const std::size_t node = sequence.size();
    if (node == chain_.evidence.size()) {
      total_ += product;
      for (std::size_t k = 0; k < node; ++k) share_[k][sequence[k]] += product;
      return;
    }
    for (std::size_t state = 0; state < chain_.states.size(); ++state) {
      const double seen = chain_.evidence[node].empty() ? 1.0 : chain_.evidence[node][state];
      const double step = moves(node, node == 0 ? 0 : sequence.back(), state);
      if (step == 0.0) continue;
      sequence.push_back(state);
      walk(sequence, product * step * seen);
      sequence.pop_back();
    }
  }

  HeadingChain chain_;
  std::vector<std::vector<double>> share_;
  double total_ = 0.0;
};

void expect_as_all_sequences(const HeadingChain& chain) {
  const AllSequences oracle(chain);
  EXPECT_NEAR(log_evidence(chain), std::log(oracle.evidence()), 1e-12);
  HeadingPosterior found = posterior(chain);
  EXPECT_EQ(found.log_evidence, log_evidence(chain));
  ASSERT_EQ(found.beliefs.size(), chain.evidence.size());
  for (std::size_t node = 0; node < found.beliefs.size(); ++node) {
    normalise(found.beliefs[node]);
    for (std::size_t state = 0; state < chain.states.size(); ++state) {
      EXPECT_NEAR(found.beliefs[node][state], oracle.share(node, state), 1e-12)
          << "node " << node << ", state " << state;
    }
  }
}

TEST(HeadingChain, SumsOverAllSequencesOfStates) {
  for (const auto scaling : {MessageScaling::after_drift, MessageScaling::after_evidence}) {
    HeadingChain chain = small_chain();
    chain.scaling = scaling;
    expect_as_all_sequences(chain);
  }
}

TEST(HeadingChain, BeginsAnewWhereOdometryDoesNotLead) {
  HeadingChain chain = small_chain();
  chain.drift[2].clear();
  expect_as_all_sequences(chain);
  // neither side knows of the other
  HeadingChain changed = chain;
  changed.evidence[3] = {1.0, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
  HeadingPosterior before = posterior(chain);
  HeadingPosterior after = posterior(changed);
  for (std::size_t state = 0; state < chain.states.size(); ++state) {
    EXPECT_EQ(before.beliefs[1][state], after.beliefs[1][state]);
  }
}

TEST(HeadingChain, TakesEvidenceThatSaysNothingAsNone) {
  HeadingChain chain = small_chain();
  const double without = log_evidence(chain);
  chain.evidence[2].assign(chain.states.size(), 1.0);
  EXPECT_NEAR(log_evidence(chain), without, 1e-12);
}

TEST(HeadingChain, TurnsWithItsEvidence) {
  // the same seen two corrections further on: the same posterior, two corrections further on
  HeadingChain turned = small_chain();
  for (HeadingBelief& evidence : turned.evidence) {
    if (evidence.empty()) continue;
    std::rotate(evidence.begin(), evidence.begin() + 3, evidence.begin() + 5);
    std::rotate(evidence.begin() + 5, evidence.begin() + 8, evidence.end());
  }
  HeadingPosterior before = posterior(small_chain());
  HeadingPosterior after = posterior(turned);
  EXPECT_NEAR(before.log_evidence, after.log_evidence, 1e-12);
  for (std::size_t s = 0; s < 5; ++s) {
    normalise(before.beliefs[2]);
    normalise(after.beliefs[2]);
    EXPECT_NEAR(after.beliefs[2][(s + 2) % 5], before.beliefs[2][s], 1e-12);
  }
}

TEST(HeadingChain, WithoutNodesSaysNothing) {
  HeadingChain chain;
  chain.states = {5, 1};
  EXPECT_EQ(log_evidence(chain), 0.0);
  EXPECT_TRUE(posterior(chain).beliefs.empty());
}

}  // namespace
}  // namespace roomatlas
