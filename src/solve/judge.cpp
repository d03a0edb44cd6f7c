// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace roomatlas {
namespace {

/// Noise beyond this many times what the information matrices say is no calibration fault.
constexpr double kMostNoise = 4.0;
/// An edge beyond this many standard deviations, with the noise scaled to fit, is no noise.
constexpr double kMostSigmas = 20.0;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string name(const PoseGraph& graph, const PoseEdge& edge) {
  return "edge from " + std::to_string(graph.ids[static_cast<std::size_t>(edge.from)]) + " to " +
         std::to_string(graph.ids[static_cast<std::size_t>(edge.to)]);
}

void warn(OptimizeResult& result, std::string field, std::string message) {
  result.issues.push_back({Severity::warning, "", 0, std::move(field), std::move(message)});
}

void note_components(const PoseGraph& graph, OptimizeResult& result) {
  constexpr std::size_t kMostNamed = 5;  // parts, in a message
  std::string ids;
  for (std::size_t c = 0; c < std::min(result.fixed.size(), kMostNamed); ++c) {
    ids +=
        (c == 0 ? "" : ", ") + std::to_string(graph.ids[static_cast<std::size_t>(result.fixed[c])]);
  }
  if (result.fixed.size() > kMostNamed) ids += " and more";
  result.issues.push_back({Severity::note, "", 0, "components",
                           "no edge joins the " + std::to_string(result.fixed.size()) +
                               " parts of the graph: each is solved by itself, with a fixed node "
                               "of its own (" +
                               ids + "), and where they lie to each other is not known"});
}

void judge_worst_edge(const PoseGraph& graph, double noise, OptimizeResult& result) {
  std::size_t worst = graph.edges.size();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!result.edges[e].accepted || graph.edges[e].cauchy_sigmas > 0.0) continue;
    if (worst == graph.edges.size() ||
        result.edges[e].chi_square > result.edges[worst].chi_square) {
      worst = e;
    }
  }
  if (worst == graph.edges.size()) return;
  const double sigmas = std::sqrt(result.edges[worst].chi_square);
  if (sigmas > kMostSigmas * std::max(1.0, noise)) {
    warn(result, name(graph, graph.edges[worst]),
         "is off by " + number(sigmas) +
             " standard deviations, far more than noise explains: it is probably wrong. "
             "--robust rejects wrong closures");
  }
}

}  // namespace

double chi_square_quantile(std::int64_t degrees_of_freedom, double normal_quantile) {
  if (degrees_of_freedom <= 0) return 0.0;
  const auto k = static_cast<double>(degrees_of_freedom);
  const double share = 2.0 / (9.0 * k);
  const double root = std::max(0.0, 1.0 - share + normal_quantile * std::sqrt(share));
  return k * root * root * root;
}

ChiSquareRange expected_chi_square(const SolverGraph& graph, std::span<const double> weights) {
  constexpr double kNormalQuantile = 3.2905;  // of 0.9995
  std::int64_t used = std::ssize(graph.edges);
  for (const double weight : weights) used -= weight == 0.0 ? 1 : 0;
  ChiSquareRange range;
  range.degrees_of_freedom = std::max<std::int64_t>(0, 3 * used + std::ssize(graph.headings) +
                                                           2 * std::ssize(graph.anchors) -
                                                           3 * std::int64_t{graph.variable_count});
  range.low = chi_square_quantile(range.degrees_of_freedom, -kNormalQuantile);
  range.high = chi_square_quantile(range.degrees_of_freedom, kNormalQuantile);
  return range;
}

void judge(const PoseGraph& graph, const Solved& solved, OptimizeResult& result) {
  if (result.fixed.size() > 1) note_components(graph, result);
  if (solved.singular_node != -1) {
    const auto node = static_cast<std::size_t>(solved.singular_node);
    const auto component = static_cast<std::size_t>(result.component[node]);
    warn(result, "node " + std::to_string(graph.ids[node]),
         "is not held by the measurements (component of node " +
             std::to_string(graph.ids[static_cast<std::size_t>(result.fixed[component])]) +
             "): some information matrices have zero rows; its pose is arbitrary");
  }
  if (!solved.converged) {
    warn(result, "solver", "did not converge (" + solved.message + "); the best state is kept");
  }
  if (solved.other_minimum >= 0.0) {
    warn(result, "minimum",
         "may not be the lowest: measured headings are so uncertain that it cannot be told how "
         "often loops wind, and other starts ended with chi-square up to " +
             number(solved.other_minimum) + " where this is " + number(result.chi_square));
  }
  if (!std::isfinite(result.chi_square)) {
    warn(result, "chi-square", "is not finite: measurements or weights are beyond reason");
    return;
  }
  const auto freedom = static_cast<double>(result.expected.degrees_of_freedom);
  const double noise = freedom > 0.0 ? std::sqrt(result.chi_square / freedom) : 1.0;
  if (result.chi_square > result.expected.high && noise > kMostNoise) {
    warn(result, "chi-square",
         "is " + number(result.chi_square) + " where at most " + number(result.expected.high) +
             " is expected: measurements contradict each other. --robust rejects wrong closures");
  } else if (result.chi_square > result.expected.high || result.chi_square < result.expected.low) {
    result.issues.push_back({Severity::note, "", 0, "chi-square",
                             "is " + number(result.chi_square) + ", expected " +
                                 number(result.expected.low) + " to " +
                                 number(result.expected.high) + ": the noise is " + number(noise) +
                                 " times what the information matrices say"});
  }
  judge_worst_edge(graph, noise, result);
}

}  // namespace roomatlas
