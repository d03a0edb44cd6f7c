// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_slips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "heading_ways.hpp"

namespace roomatlas {
namespace {

/// A way that goes over to the other winding between two nodes.
struct Crossing {
  double log_odds = -std::numeric_limits<double>::infinity();
  std::size_t node = 0;  ///< the second
  std::size_t from = 0;  ///< states
  std::size_t to = 0;
};

/// All ways that wind a quarter turn more than the reference, and where they may do so.
struct Windings {
  const HeadingChain& chain;
  StatesBeside states;
  HeadingWays until;
  HeadingWays since;

  Windings(const HeadingChain& of, const std::vector<double>& reference_rad, int sign)
      : chain(of),
        states(of, reference_rad, sign),
        until(ways_until(of, states)),
        since(ways_since(of, states)) {}

  /// Of the likeliest way that never goes over.
  [[nodiscard]] double stays_log_odds() const {
    const std::vector<double>& ends = until.log_odds.back();
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t state = 0; state < ends.size(); ++state) {
      if (states.is_near(state)) best = std::max(best, ends[state]);
    }
    return best;
  }
};

/// The likeliest that goes over on its way into a node.
Crossing crossing_into(const Windings& windings, std::size_t node) {
  const StatesBeside& states = windings.states;
  const HeadingDrift& moves = windings.chain.drift[node];
  const int width = static_cast<int>(moves.size() / 2);
  const int drift = states.drift(node - 1, node);
  const auto row = static_cast<int>(states.row());
  Crossing best;
  best.node = node;
  for (std::size_t to = 0; to < states.size(); ++to) {
    if (states.is_near(to)) continue;
    const int stays_at = static_cast<int>(to % states.row()) + drift;
    const std::size_t first_of_row = to - to % states.row();
    for (int at = std::max(0, stays_at - width); at <= std::min(row - 1, stays_at + width); ++at) {
      const std::size_t from = first_of_row + static_cast<std::size_t>(at);
      if (!states.is_near(from)) break;
      const double odds = windings.until.log_odds[node - 1][from] +
                          windings.since.log_odds[node][to] +
                          std::log(moves[static_cast<std::size_t>(stays_at - at + width)].share);
      if (odds > best.log_odds) best = {odds, node, from, to};
    }
  }
  return best;
}

/// Marks the slope of a peak to one side: until the odds rise again from a valley.
void mark_slope(const std::vector<Crossing>& crossings, std::size_t peak, int direction,
                std::vector<char>& marked) {
  constexpr double kValley = 2.0;  // of log odds; less finds each place many times
  double lowest = crossings[peak].log_odds;
  const auto count = static_cast<std::ptrdiff_t>(crossings.size());
  for (auto k = static_cast<std::ptrdiff_t>(peak); k >= 0 && k < count; k += direction) {
    const auto at = static_cast<std::size_t>(k);
    if (crossings[at].log_odds > lowest + kValley) return;
    lowest = std::min(lowest, crossings[at].log_odds);
    marked[at] = 1;
  }
}

/// The places that the walls leave open: the likeliest crossing of each.
std::vector<Crossing> peaks_of(const std::vector<Crossing>& crossings) {
  std::vector<std::size_t> order(crossings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return crossings[a].log_odds > crossings[b].log_odds;
  });
  std::vector<Crossing> peaks;
  std::vector<char> marked(crossings.size(), 0);
  for (const std::size_t at : order) {
    if (marked[at] != 0 || !std::isfinite(crossings[at].log_odds)) continue;
    peaks.push_back(crossings[at]);
    mark_slope(crossings, at, 1, marked);
    mark_slope(crossings, at, -1, marked);
  }
  return peaks;
}

/// The way through a crossing, from where it leaves the reference to where it has turned by all.
HeadingSlip slip_through(const Crossing& crossing, const Windings& windings) {
  constexpr double kAgreeRad = radians(5.0);  // nearer the reference, a way is the reference
  const StatesBeside& states = windings.states;
  const double step_rad = windings.chain.states.step_rad();
  const int agree = static_cast<int>(kAgreeRad / step_rad);
  std::vector<int> beyond;  // first backwards from the crossing, then on from it
  std::size_t node = crossing.node - 1;
  for (std::size_t state = crossing.from; states.beyond(state) > agree;) {
    beyond.push_back(states.beyond(state));
    if (node == 0) break;
    state = static_cast<std::size_t>(windings.until.from[node--][state]);
  }
  HeadingSlip slip;
  slip.log_odds = crossing.log_odds - windings.stays_log_odds();
  slip.first_node = crossing.node - beyond.size();
  std::reverse(beyond.begin(), beyond.end());
  const std::size_t last_node = windings.chain.evidence.size() - 1;
  node = crossing.node;
  for (std::size_t state = crossing.to;
       node < last_node && states.beyond(state) < states.quarter() - agree;) {
    beyond.push_back(states.beyond(state));
    state = static_cast<std::size_t>(windings.since.from[node++][state]);
  }
  beyond.push_back(states.quarter());
  for (const int steps : beyond) {
    slip.more_rad.push_back(states.sign() * std::min(steps, states.quarter()) * step_rad);
  }
  return slip;
}

}  // namespace

bool are_one(const HeadingSlip& a, const HeadingSlip& b) {
  const auto are_together = [](std::size_t one, std::size_t other) {
    constexpr std::size_t kTogether = 12;  // nodes, 3.6 m; more takes two places for one
    return std::max(one, other) - std::min(one, other) < kTogether;
  };
  return a.more_rad.back() == b.more_rad.back() && are_together(a.first_node, b.first_node) &&
         are_together(a.first_node + a.more_rad.size(), b.first_node + b.more_rad.size());
}

std::vector<HeadingSlip> find_slips(std::span<const HeadingNode> nodes,
                                    std::span<const WallSighting> sightings,
                                    std::span<const double> directions_rad,
                                    const SightingChainOptions& options,
                                    const std::vector<double>& correction_rad,
                                    double least_log_odds) {
  const HeadingChain chain = sighting_chain(nodes, sightings, directions_rad, options);
  std::vector<HeadingSlip> all;
  for (const int sign : {1, -1}) {
    const Windings windings(chain, correction_rad, sign);
    std::vector<Crossing> crossings;
    for (std::size_t node = 1; node < nodes.size(); ++node) {
      crossings.push_back(crossing_into(windings, node));
    }
    for (const Crossing& peak : peaks_of(crossings)) {
      all.push_back(slip_through(peak, windings));
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const HeadingSlip& a, const HeadingSlip& b) {
    return a.log_odds > b.log_odds;
  });
  std::vector<HeadingSlip> slips;
  for (HeadingSlip& slip : all) {
    if (slip.log_odds < least_log_odds) break;
    const bool is_known = std::any_of(
        slips.begin(), slips.end(), [&](const HeadingSlip& other) { return are_one(slip, other); });
    if (!is_known) slips.push_back(std::move(slip));
  }
  return slips;
}

}  // namespace roomatlas
