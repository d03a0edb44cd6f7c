// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_ways.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace roomatlas {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kMarginRad = radians(20.0);  // to both sides: a heading is seldom farther off its
                                              // mean, and each more costs time

/// Ends of ways at one node.
struct Ends {
  std::vector<double> log_odds;
  std::vector<std::int32_t> from;
};

/// Rarely, the walls around follow another direction from here on.
Ends with_switches(const HeadingChain& chain, const StatesBeside& states,
                   const std::vector<double>& log_odds) {
  Ends ends{log_odds, std::vector<std::int32_t>(states.size())};
  std::iota(ends.from.begin(), ends.from.end(), 0);
  const auto others = static_cast<double>(chain.states.directions - 1);
  if (others == 0.0) return ends;
  const double stays = std::log(1.0 - chain.switch_share);
  const double leaves = std::log(chain.switch_share / others);
  for (std::size_t state = 0; state < states.size(); ++state) {
    double& best = ends.log_odds[state];
    best += stays;
    for (std::size_t at = state % states.row(); at < states.size(); at += states.row()) {
      if (at == state || log_odds[at] + leaves <= best) continue;
      best = log_odds[at] + leaves;
      ends.from[state] = static_cast<std::int32_t>(at);
    }
  }
  return ends;
}

/// Ends at the next node: of all ways there, the likeliest to each state.
Ends after_drift(const Ends& ends, const StatesBeside& states, const HeadingDrift& moves,
                 int drift) {
  std::vector<double> log_share(moves.size());
  std::transform(moves.begin(), moves.end(), log_share.begin(),
                 [](const HeadingMove& move) { return std::log(move.share); });
  const int width = static_cast<int>(moves.size() / 2);
  const int row = static_cast<int>(states.row());
  Ends next{std::vector<double>(states.size(), kNever),
            std::vector<std::int32_t>(states.size(), 0)};
  for (std::size_t to = 0; to < states.size(); ++to) {
    const std::size_t first_of_row = to - to % states.row();
    const int stays_at = static_cast<int>(to % states.row()) + drift;
    const int last = std::min(row - 1, stays_at + width);
    for (int at = std::max(0, stays_at - width); at <= last; ++at) {
      const std::size_t from = first_of_row + static_cast<std::size_t>(at);
      const double odds =
          ends.log_odds[from] + log_share[static_cast<std::size_t>(stays_at - at + width)];
      if (odds <= next.log_odds[to]) continue;
      next.log_odds[to] = odds;
      next.from[to] = ends.from[from];
    }
  }
  return next;
}

void add_evidence(const HeadingChain& chain, const StatesBeside& states, std::size_t node,
                  std::vector<double>& log_odds) {
  const HeadingBelief& evidence = chain.evidence[node];
  if (evidence.empty()) return;
  for (std::size_t state = 0; state < states.size(); ++state) {
    log_odds[state] += std::log(evidence[states.belief_at(node, state)]);
  }
}

/// Viterbi's pass over nodes in the given order.
HeadingWays ways_along(const HeadingChain& chain, const StatesBeside& states,
                       const std::vector<std::size_t>& order, bool begin_near) {
  HeadingWays ways;
  ways.log_odds.resize(order.size());
  ways.from.resize(order.size());
  Ends ends{std::vector<double>(states.size(), kNever), {}};
  for (std::size_t state = 0; state < states.size(); ++state) {
    if (states.is_near(state) == begin_near) ends.log_odds[state] = 0.0;
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t node = order[i];
    if (i > 0) {
      const std::size_t before = order[i - 1];
      ends = after_drift(with_switches(chain, states, ends.log_odds), states,
                         chain.drift[std::max(node, before)], states.drift(before, node));
    }
    add_evidence(chain, states, node, ends.log_odds);
    ways.log_odds[node] = ends.log_odds;
    ways.from[node] = ends.from;
  }
  return ways;
}

std::vector<std::size_t> nodes_of(const HeadingChain& chain) {
  std::vector<std::size_t> order(chain.evidence.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

}  // namespace

StatesBeside::StatesBeside(const HeadingChain& chain, const std::vector<double>& reference_rad,
                           int sign)
    : sign_(sign),
      margin_(static_cast<int>(kMarginRad / chain.states.step_rad())),
      quarter_(static_cast<int>(chain.states.corrections)),
      corrections_(chain.states.corrections),
      directions_(chain.states.directions) {
  for (const double correction : reference_rad) {
    reference_.push_back(static_cast<int>(std::lround(correction / chain.states.step_rad())));
  }
}

std::size_t StatesBeside::belief_at(std::size_t node, std::size_t state) const {
  const int correction = reference_[node] + sign_ * beyond(state);
  const int wrapped = (correction % quarter_ + quarter_) % quarter_;
  return state / row() * corrections_ + static_cast<std::size_t>(wrapped);
}

HeadingWays ways_until(const HeadingChain& chain, const StatesBeside& states) {
  return ways_along(chain, states, nodes_of(chain), true);
}

HeadingWays ways_since(const HeadingChain& chain, const StatesBeside& states) {
  std::vector<std::size_t> order = nodes_of(chain);
  std::reverse(order.begin(), order.end());
  return ways_along(chain, states, order, false);
}

}  // namespace roomatlas
