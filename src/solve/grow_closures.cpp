// SPDX-License-Identifier: GPL-3.0-or-later
#include "grow_closures.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "index.hpp"

namespace roomatlas {
namespace {

/// Squared distance beyond which a closure does not fit: a true one is farther once in 10^6, but
/// real noise has longer tails than the normal distribution.
constexpr double kGate = 30.0;
/// A closure is sharp when a false one, lying anywhere, would fit with at most this probability.
constexpr double kChance = 1e-3;
/// In the end closures up to this distance come back where even that is sharp: on real graphs the
/// worst true closures were found up to 230, false ones from 1200 on.
constexpr double kWideGate = 300.0;
constexpr double kWideChance = 1e-4;  // more would let false ones in by the wider gate
/// What one in a hundred exceeds where noise is normal. Simulated graphs keep to it; on recorded
/// ones three to six in a hundred were farther.
constexpr double kHundredth = 11.34;
constexpr double kLongTail = 0.02;   // of the accepted: with more beyond it, closures come back
constexpr int kMostRounds = 200;     // each accepts or drops something; only to be sure of an end
constexpr int kMostWideRounds = 10;  // the same when closures come back
constexpr int kMostDrops = 3;        // a closure dropped so often stays out: it would come again
constexpr std::size_t kHypotheses = 8;  // tried where all are ambiguous; each costs a solution
constexpr double kLeastNoise = 1e-4;    // as a variance factor: closures that fit exactly ...
constexpr double kMostNoise = 9.0;  // ... and more would let false closures widen their own gate
constexpr std::size_t kEnoughToTell = 10;    // accepted closures, from which on noise is estimated
constexpr double kMostRejected = 1.0 / 3.0;  // of all closures; beyond it a warning is given
constexpr double kNearlyAsBad = 0.5;         // of the worst distance: dropped together with it
constexpr double kNarrowest = 0.1;         // of a map's length: its width where all lies on a line
constexpr double kLeastArea = 1e-12;       // where all lies in one point
constexpr std::size_t kEnoughSupport = 3;  // others that bear out a rejected closure, to warn of it

double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + rank);
  return values[at(rank)];
}

/// Logarithm of the volume in which loop ends may lie: the area of the map times a full turn.
double log_volume_of(const SlotPoses& state) {
  double low[2] = {0.0, 0.0};
  double high[2] = {0.0, 0.0};
  for (std::size_t k = 0; k + 2 < state.size(); k += 3) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], state[k + i]);
      high[i] = std::max(high[i], state[k + i]);
    }
  }
  const double wide = std::max(high[0] - low[0], high[1] - low[1]);
  const double narrow = std::max(std::min(high[0] - low[0], high[1] - low[1]), kNarrowest * wide);
  return std::log(std::max(wide * narrow, kLeastArea) * 2.0 * kPi);
}

}  // namespace

ClosureGrowth::ClosureGrowth(const PoseGraph& poses, LeastSquares& squares)
    : poses_(poses), squares_(squares) {
  const SolverGraph& graph = squares.graph();
  weights_.resize(graph.edges.size());
  drops_.assign(graph.edges.size(), 0);
  for (std::size_t e = 0; e < weights_.size(); ++e) {
    weights_[e] = poses.edges[at(graph.edge_index[e])].kind == EdgeKind::loop ? 0.0 : 1.0;
  }
  solved_.state = squares.odometry();
  for (const std::int32_t e : squares.bridges()) weights_[at(e)] = 1.0;
}

bool ClosureGrowth::is_accepted(const ClosureTest& test) const {
  return weights_[at(test.edge)] > 0.0;
}
/// Logarithm of the probability that a false closure, lying anywhere, is at most this far off.
double ClosureGrowth::log_chance(const ClosureTest& test, double distance) const {
  return test.log_volume + std::log(4.0 / 3.0 * kPi) + 1.5 * std::log(distance) -
         log_search_volume_;
}
bool ClosureGrowth::fits(const ClosureTest& test) const {
  if (test.distance <= kGate * noise_variance_) return true;
  return wide_ && test.distance <= kWideGate * noise_variance_ &&
         log_chance(test, test.distance) < std::log(kWideChance);
}
bool ClosureGrowth::is_sharp(const ClosureTest& test) const {
  return log_chance(test, kGate * noise_variance_) < std::log(kChance);
}
void ClosureGrowth::accept(const ClosureTest& test) { weights_[at(test.edge)] = 1.0; }

void ClosureGrowth::solve_and_test() {
  const int before = solved_.iterations;
  solved_ = squares_.solve_from(solved_.state, weights_);
  solved_.iterations += before;
  tests_ = test_closures(poses_, squares_, solved_.state, weights_);
  log_search_volume_ = log_volume_of(solved_.state);
}

void ClosureGrowth::estimate_noise() {
  std::vector<double> distances;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test)) distances.push_back(test.distance);
  }
  constexpr double kMedian = 2.366;  // of chi-square with 3 degrees of freedom
  constexpr double kTenth = 6.251;   // what one in ten exceeds
  if (distances.size() < kEnoughToTell) return;
  noise_variance_ =
      std::clamp(std::max(quantile(distances, 0.5) / kMedian, quantile(distances, 0.9) / kTenth),
                 kLeastNoise, kMostNoise);
}

/// Drops the worst, and all that are nearly as bad: a false closure makes true ones beside it fail.
bool ClosureGrowth::drop_misfits() {
  double worst = 0.0;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test) && !fits(test)) worst = std::max(worst, test.distance);
  }
  if (worst == 0.0) return false;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test) && !fits(test) && test.distance >= kNearlyAsBad * worst) {
      weights_[at(test.edge)] = 0.0;
      ++drops_[at(test.edge)];
    }
  }
  return true;
}

bool ClosureGrowth::accept_sharp() {
  bool any = false;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test) || !fits(test) || !is_sharp(test)) continue;
    if (drops_[at(test.edge)] >= kMostDrops) continue;
    accept(test);
    any = true;
  }
  return any;
}

/// Other closures that fit sharply once a hypothesis is accepted.
std::vector<std::size_t> ClosureGrowth::supporters_of(std::size_t hypothesis) {
  std::vector<double> weights = weights_;
  weights[at(tests_[hypothesis].edge)] = 1.0;
  const Solved solved = squares_.solve_from(solved_.state, weights);
  solved_.iterations += solved.iterations;
  const std::vector<ClosureTest> tests = test_closures(poses_, squares_, solved.state, weights);
  std::vector<std::size_t> supporters;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    if (k != hypothesis && weights[at(tests[k].edge)] == 0.0 && fits(tests[k]) &&
        is_sharp(tests[k])) {
      supporters.push_back(k);
    }
  }
  return supporters;
}

bool ClosureGrowth::accept_best_supported() {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tests_.size(); ++k) {
    if (!is_accepted(tests_[k]) && fits(tests_[k]) && drops_[at(tests_[k].edge)] < kMostDrops) {
      open.push_back(k);
    }
  }
  if (open.empty()) return false;
  std::ranges::stable_sort(open, [&](std::size_t a, std::size_t b) {
    return tests_[a].log_volume < tests_[b].log_volume;
  });
  struct Hypothesis {
    std::size_t test;
    std::vector<std::size_t> supporters;
  };
  std::vector<Hypothesis> hypotheses;
  std::vector<std::uint8_t> explained(tests_.size(), 0);
  for (const std::size_t k : open) {
    if (explained[k] != 0) continue;  // a supporter of another hypothesis says the same
    if (hypotheses.size() == kHypotheses) break;
    hypotheses.push_back({k, supporters_of(k)});
    for (const std::size_t other : hypotheses.back().supporters) explained[other] = 1;
  }
  const auto best = std::ranges::max_element(
      hypotheses, {}, [](const Hypothesis& h) { return h.supporters.size(); });
  accept(tests_[best->test]);
  for (const std::size_t k : best->supporters) accept(tests_[k]);
  for (const Hypothesis& h : hypotheses) {
    if (is_accepted(tests_[h.test]) || h.supporters.size() < kEnoughSupport) continue;
    if (2 * h.supporters.size() >= best->supporters.size()) {
      rivals_.push_back({tests_[h.test].edge, h.supporters.size(), best->supporters.size()});
    }
  }
  return true;
}

/// Rounds until nothing changes.
void ClosureGrowth::grow() {
  for (int round = 0; round < kMostRounds; ++round) {
    solve_and_test();
    if (tests_.empty()) return;
    estimate_noise();
    if (!drop_misfits() && !accept_sharp() && !accept_best_supported()) return;
  }
}

/// Whether the accepted closures are far off more often than normal noise would have it.
bool ClosureGrowth::has_long_tails() const {
  std::ptrdiff_t accepted = 0;
  std::ptrdiff_t far = 0;
  for (const ClosureTest& test : tests_) {
    if (!is_accepted(test)) continue;
    ++accepted;
    far += test.distance > kHundredth * noise_variance_ ? 1 : 0;
  }
  return static_cast<double>(far) > kLongTail * static_cast<double>(accepted);
}

/// Takes back what is off, but by far less than a false closure would be.
void ClosureGrowth::widen() {
  wide_ = true;
  drops_.assign(drops_.size(), 0);
  for (int round = 0; round < kMostWideRounds; ++round) {
    if (!drop_misfits() && !accept_sharp()) return;
    solve_and_test();
  }
}

void ClosureGrowth::run() {
  grow();
  if (has_long_tails()) widen();
  Solved global =
      squares_.solve(weights_);  // growing follows one valley: there may be a deeper one
  const int iterations = solved_.iterations + global.iterations;
  if (global.chi_square <= solved_.chi_square) solved_ = std::move(global);
  solved_.iterations = iterations;
  warn();
}

void ClosureGrowth::warn() {
  const auto add = [&](std::string field, std::string message) {
    issues_.push_back({Severity::warning, "", 0, std::move(field), std::move(message)});
  };
  const auto rejected =
      std::ranges::count_if(tests_, [&](const ClosureTest& test) { return !is_accepted(test); });
  if (static_cast<double>(rejected) > kMostRejected * static_cast<double>(tests_.size())) {
    add("closures", std::to_string(rejected) + " of " + std::to_string(tests_.size()) +
                        " were rejected: with so many contradictions the accepted ones cannot be "
                        "trusted either");
  }
  for (const Rival& rival : rivals_) {
    if (weights_[at(rival.edge)] > 0.0) continue;
    const PoseEdge& edge = poses_.edges[at(squares_.graph().edge_index[at(rival.edge)])];
    add("closure from " + std::to_string(poses_.ids[at(edge.from)]) + " to " +
            std::to_string(poses_.ids[at(edge.to)]),
        "was rejected although " + std::to_string(rival.supporters) +
            " others bear it out, where " + std::to_string(rival.against) +
            " bear out what was accepted instead: the choice is doubtful");
  }
}

}  // namespace roomatlas
