// SPDX-License-Identifier: GPL-3.0-or-later
#include "grow_closures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace roomatlas {
namespace {

constexpr std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

/// Squared distance beyond which a closure does not fit: a true one is farther once in 10^6, but
/// real noise has longer tails than the normal distribution.
constexpr double kGate = 30.0;
/// A closure is sharp when a false one, lying anywhere, would fit with at most this probability.
constexpr double kChance = 1e-3;
constexpr int kMostRounds = 200;
constexpr int kMostDrops = 3;
constexpr std::size_t kHypotheses = 10;
constexpr double kLeastNoise = 0.01;
constexpr double kMostNoise = 9.0;

double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + rank);
  return values[at(rank)];
}

/// Logarithm of the volume in which loop ends may lie: the area of the map times a full turn.
double log_volume_of(const State& state) {
  double low[2] = {0.0, 0.0};
  double high[2] = {0.0, 0.0};
  for (std::size_t k = 0; k + 2 < state.size(); k += 3) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], state[k + i]);
      high[i] = std::max(high[i], state[k + i]);
    }
  }
  const double wide = std::max(high[0] - low[0], high[1] - low[1]);
  const double narrow = std::max(std::min(high[0] - low[0], high[1] - low[1]), 0.1 * wide);
  return std::log(std::max(wide * narrow, 1e-12) * 2.0 * kPi);
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
}

bool ClosureGrowth::is_accepted(const ClosureTest& test) const {
  return weights_[at(test.edge)] > 0.0;
}
bool ClosureGrowth::fits(const ClosureTest& test) const {
  return test.distance <= kGate * noise_variance_;
}
bool ClosureGrowth::is_sharp(const ClosureTest& test) const {
  const double log_gate = std::log(4.0 / 3.0 * kPi) + 1.5 * std::log(kGate * noise_variance_);
  return test.log_volume + log_gate - log_search_volume_ < std::log(kChance);
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
  if (distances.size() < 10) return;
  noise_variance_ = std::clamp(
      std::max(quantile(distances, 0.5) / kMedian, quantile(distances, 0.9) / kTenth), kLeastNoise,
      kMostNoise);
}

/// Drops the worst, and all that are nearly as bad: a false closure makes true ones beside it fail.
bool ClosureGrowth::drop_misfits() {
  double worst = 0.0;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test) && !fits(test)) worst = std::max(worst, test.distance);
  }
  if (worst == 0.0) return false;
  for (const ClosureTest& test : tests_) {
    if (is_accepted(test) && !fits(test) && test.distance >= 0.5 * worst) {
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
  std::vector<std::size_t> best;
  std::size_t chosen = open.front();
  std::vector<std::uint8_t> explained(tests_.size(), 0);
  std::size_t tried = 0;
  for (const std::size_t k : open) {
    if (explained[k] != 0) continue;  // a supporter of another hypothesis says the same
    if (++tried > kHypotheses) break;
    std::vector<std::size_t> supporters = supporters_of(k);
    for (const std::size_t other : supporters) explained[other] = 1;
    if (supporters.size() > best.size()) {
      best = std::move(supporters);
      chosen = k;
    }
  }
  accept(tests_[chosen]);
  for (const std::size_t k : best) accept(tests_[k]);
  if (best.empty()) unsupported_.push_back(tests_[chosen].edge);
  return true;
}

void ClosureGrowth::run() {
  const bool trace = std::getenv("TRACE") != nullptr;
  for (int round = 0; round < kMostRounds; ++round) {
    solve_and_test();
    if (tests_.empty()) return;
    estimate_noise();
    const char* what = "sharp";
    bool go = drop_misfits();
    if (go) {
      what = "drop";
    } else {
      go = accept_sharp();
      if (!go) {
        what = "hypo";
        go = accept_best_supported();
      }
    }
    if (trace) {
      std::ptrdiff_t n = 0;
      for (const auto& t : tests_) n += is_accepted(t);
      std::fprintf(stderr, "round %d %s accepted %td of %zu noise %.4g chi2 %.4g\n", round, what, n,
                   tests_.size(), noise_variance_, solved_.chi_square);
    }
    if (!go) break;
  }
}

}  // namespace roomatlas
