// SPDX-License-Identifier: GPL-3.0-or-later
#include "heading_priors.hpp"

#include <cmath>

#include "index.hpp"

namespace roomatlas {
namespace {

std::size_t component_of(const PoseGraph& poses, const SolverGraph& graph, std::size_t heading) {
  return at(graph.components.component[at(poses.headings[heading].node)]);
}

std::vector<std::int32_t> component_of_slot(const SolverGraph& graph) {
  std::vector<std::int32_t> component(graph.slot.size());
  for (std::size_t i = 0; i < graph.slot.size(); ++i) {
    component[at(graph.slot[i])] = graph.components.component[i];
  }
  return component;
}

/// Angle of each component's votes, 0 where there are none.
std::vector<double> angles_of(const std::vector<Point2>& votes) {
  std::vector<double> angles;
  angles.reserve(votes.size());
  for (const Point2& vote : votes) {
    angles.push_back(vote.isZero() ? 0.0 : std::atan2(vote.y(), vote.x()));
  }
  return angles;
}

void turn_components(const SolverGraph& graph, const std::vector<double>& turn_rad,
                     SlotPoses& state) {
  const std::vector<std::int32_t> component = component_of_slot(graph);
  for (std::size_t slot = 0; slot < component.size(); ++slot) {
    const double turn = turn_rad[at(component[slot])];
    if (turn == 0.0) continue;
    const double* const root = state.data() + std::ptrdiff_t{graph.roots[at(component[slot])]} * 3;
    double* const p = state.data() + slot * 3;
    const Point2 moved = direction(turn).x() * Point2(p[0] - root[0], p[1] - root[1]) +
                         direction(turn).y() * Point2(root[1] - p[1], p[0] - root[0]);
    p[0] = root[0] + moved.x();
    p[1] = root[1] + moved.y();
    p[2] = wrap_angle(p[2] + turn);
  }
}

}  // namespace

void settle_quarters(const PoseGraph& poses, const SlotPoses& state, SolverGraph& graph) {
  for (std::size_t k = 0; k < graph.headings.size(); ++k) {
    if (!poses.headings[k].modulo_quarter) continue;
    SolverHeading& heading = graph.headings[k];
    const double now = state[at(heading.slot) * 3 + 2];
    heading.theta_rad = wrap_angle(now - wrap_quarter(now - poses.headings[k].theta_rad));
  }
}

void turn_to_quarters(const PoseGraph& poses, const SolverGraph& graph, SlotPoses& state) {
  const std::vector<Point2> none(graph.roots.size(), Point2::Zero());
  std::vector<Point2> full = none;
  std::vector<Point2> quarters = none;  // votes at four times the angle
  for (std::size_t k = 0; k < graph.headings.size(); ++k) {
    const SolverHeading& heading = graph.headings[k];
    const double off = heading.theta_rad - state[at(heading.slot) * 3 + 2];
    const std::size_t c = component_of(poses, graph, k);
    if (poses.headings[k].modulo_quarter) {
      quarters[c] += heading.information * direction(4.0 * off);
    } else {
      full[c] += heading.information * direction(off);
    }
  }
  std::vector<double> turns = angles_of(quarters);
  const std::vector<double> full_turns = angles_of(full);
  for (std::size_t c = 0; c < turns.size(); ++c) {
    turns[c] = full[c].isZero() ? turns[c] / 4.0 : full_turns[c];
  }
  turn_components(graph, turns, state);
}

void turn_to_headings(const SolverGraph& graph, SlotPoses& state) {
  if (graph.headings.empty()) return;
  const std::vector<std::int32_t> component = component_of_slot(graph);
  std::vector<Point2> votes(graph.roots.size(), Point2::Zero());
  for (const SolverHeading& heading : graph.headings) {
    const double off = heading.theta_rad - state[at(heading.slot) * 3 + 2];
    votes[at(component[at(heading.slot)])] += heading.information * direction(off);
  }
  turn_components(graph, angles_of(votes), state);
}

}  // namespace roomatlas
