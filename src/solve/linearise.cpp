// SPDX-License-Identifier: GPL-3.0-or-later
#include "linearise.hpp"

#include <algorithm>
#include <cmath>

#include "index.hpp"

namespace roomatlas {
namespace {

/// One edge at a state, all in the world's frame.
struct Terms {
  double w[6];      ///< information: xx, xy, yy, xt, yt, tt
  double force[3];  ///< information times error
  double q[2];      ///< step turned by 90 degrees
  double chi_square;
};

/// Cosine and sine of each heading.
std::vector<Point2> directions_of(const SlotPoses& state) {
  std::vector<Point2> directions(state.size() / 3);
  for (std::size_t k = 0; k < directions.size(); ++k) directions[k] = direction(state[k * 3 + 2]);
  return directions;
}

Terms terms_of(const SolverEdge& edge, const SlotPoses& state,
               const std::vector<Point2>& directions, StepSource source) {
  const double* const from = state.data() + std::ptrdiff_t{edge.from} * 3;
  const double* const to = state.data() + std::ptrdiff_t{edge.to} * 3;
  const double c = directions[at(edge.from)].x();
  const double s = directions[at(edge.from)].y();
  const double dx = to[0] - from[0];
  const double dy = to[1] - from[1];
  const double mx = c * edge.x_m - s * edge.y_m;  // the measured step, in the world
  const double my = s * edge.x_m + c * edge.y_m;
  const double ex = dx - mx;
  const double ey = dy - my;
  const double et = wrap_angle(to[2] - from[2] - edge.theta_rad);

  Terms t;
  const double* const o = edge.information;
  const double cross = c * s * (o[0] - o[2]) + (c * c - s * s) * o[1];
  const double twice = 2.0 * c * s * o[1];
  t.w[0] = c * c * o[0] - twice + s * s * o[2];
  t.w[1] = cross;
  t.w[2] = s * s * o[0] + twice + c * c * o[2];
  t.w[3] = c * o[3] - s * o[4];
  t.w[4] = s * o[3] + c * o[4];
  t.w[5] = o[5];
  t.force[0] = t.w[0] * ex + t.w[1] * ey + t.w[3] * et;
  t.force[1] = t.w[1] * ex + t.w[2] * ey + t.w[4] * et;
  t.force[2] = t.w[3] * ex + t.w[4] * ey + t.w[5] * et;
  t.chi_square = ex * t.force[0] + ey * t.force[1] + et * t.force[2];
  const bool measured = source == StepSource::measured;
  t.q[0] = measured ? -my : -dy;
  t.q[1] = measured ? mx : dx;
  return t;
}

/// Scales by the edge's weight and that of its loss.
void weigh(const SolverEdge& edge, double weight, StepSource source, Terms& t) {
  const double sigmas = source == StepSource::state ? edge.cauchy_sigmas : 0.0;
  if (weight == 1.0 && sigmas == 0.0) return;
  const double scale = weight * cauchy_weight(t.chi_square, sigmas);
  t.chi_square = weight * cauchy_loss(t.chi_square, sigmas);
  for (double& value : t.w) value *= scale;
  for (double& value : t.force) value *= scale;
}

double error_of(const SolverHeading& heading, const SlotPoses& state) {
  return wrap_angle(state[at(heading.slot) * 3 + 2] - heading.theta_rad);
}

/// Headings and anchors act on a single node.
double add_unary(const SolverGraph& graph, const SlotPoses& state, std::vector<double>& right_side,
                 NormalEquations* equations) {
  const auto add_to_diagonal = [&](std::int32_t slot, std::ptrdiff_t row, double value) {
    if (equations == nullptr) return;
    const BlockPlace place = equations->places.diagonal[at(slot)];
    equations->matrix.values()[place.offset + row * place.stride + row] += value;
  };
  double sum = 0.0;
  for (const SolverHeading& heading : graph.headings) {
    const double error = error_of(heading, state);
    const double chi_square = error * error * heading.information;
    const double weight = heading.information * cauchy_weight(chi_square, heading.cauchy_sigmas);
    right_side[at(heading.slot) * 3 + 2] -= weight * error;
    add_to_diagonal(heading.slot, 2, weight);
    sum += cauchy_loss(chi_square, heading.cauchy_sigmas);
  }
  for (const Anchor& anchor : graph.anchors) {
    for (std::ptrdiff_t row = 0; row < 2; ++row) {
      const std::size_t place = at(anchor.slot) * 3 + at(row);
      right_side[place] -= anchor.information * state[place];
      add_to_diagonal(anchor.slot, row, anchor.information);
    }
  }
  return sum;
}

/// The right side is minus the Jacobians' transposes times the force.
void add_forces(const SolverEdge& edge, const Terms& t, std::int32_t variables,
                std::vector<double>& right_side) {
  if (edge.to < variables) {
    double* const to = right_side.data() + std::ptrdiff_t{edge.to} * 3;
    for (int i = 0; i < 3; ++i) to[i] -= t.force[i];
  }
  if (edge.from < variables) {
    double* const from = right_side.data() + std::ptrdiff_t{edge.from} * 3;
    from[0] += t.force[0];
    from[1] += t.force[1];
    from[2] += t.force[2] + t.q[0] * t.force[0] + t.q[1] * t.force[1];
  }
}

/// The lower half of a symmetric block.
struct Lower {
  double xx, yx, tx, yy, ty, tt;
};

void add_lower(double* block, std::ptrdiff_t stride, const Lower& lower) {
  block[0] += lower.xx;
  block[1] += lower.yx;
  block[2] += lower.tx;
  block[stride + 1] += lower.yy;
  block[stride + 2] += lower.ty;
  block[2 * stride + 2] += lower.tt;
}

void add_blocks(const SolverEdge& edge, const Terms& t, const EdgePlaces& place,
                std::int32_t variables, NormalEquations& equations) {
  double* const values = equations.matrix.values();
  const double* const w = t.w;
  if (edge.to < variables) {
    const BlockPlace to = equations.places.diagonal[at(edge.to)];
    add_lower(values + to.offset, to.stride, {w[0], w[1], w[3], w[2], w[4], w[5]});
  }
  if (edge.from >= variables) return;
  const double p[3] = {w[3] + t.q[0] * w[0] + t.q[1] * w[1], w[4] + t.q[0] * w[1] + t.q[1] * w[2],
                       w[5] + t.q[0] * w[3] + t.q[1] * w[4]};  // the last row of T'W
  const BlockPlace from = equations.places.diagonal[at(edge.from)];
  add_lower(values + from.offset, from.stride,
            {w[0], w[1], p[0], w[2], p[1], p[2] + p[0] * t.q[0] + p[1] * t.q[1]});
  if (place.between == -1) return;
  const double rows[3][3] = {{w[0], w[1], w[3]}, {w[1], w[2], w[4]}, {p[0], p[1], p[2]}};
  double* const between = values + place.between;
  if (edge.from > edge.to) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) between[i + j * std::ptrdiff_t{place.stride}] -= rows[i][j];
    }
  } else {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) between[i + j * std::ptrdiff_t{place.stride}] -= rows[j][i];
    }
  }
}

double weight_of(std::span<const double> weights, std::size_t e) {
  return weights.empty() ? 1.0 : weights[e];
}

}  // namespace

double linearise(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                 StepSource source, NormalEquations& equations) {
  equations.matrix.clear();
  equations.right_side.assign(at(graph.variable_count) * 3, 0.0);
  const std::vector<Point2> directions = directions_of(state);
  double sum = 0.0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double weight = weight_of(weights, e);
    if (weight == 0.0) continue;
    Terms terms = terms_of(graph.edges[e], state, directions, source);
    weigh(graph.edges[e], weight, source, terms);
    add_forces(graph.edges[e], terms, graph.variable_count, equations.right_side);
    add_blocks(graph.edges[e], terms, equations.places.between[e], graph.variable_count, equations);
    sum += terms.chi_square;
  }
  return sum + add_unary(graph, state, equations.right_side, &equations);
}

double gradient(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                std::vector<double>& right_side) {
  right_side.assign(at(graph.variable_count) * 3, 0.0);
  const std::vector<Point2> directions = directions_of(state);
  double sum = 0.0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double weight = weight_of(weights, e);
    if (weight == 0.0) continue;
    Terms terms = terms_of(graph.edges[e], state, directions, StepSource::state);
    weigh(graph.edges[e], weight, StepSource::state, terms);
    add_forces(graph.edges[e], terms, graph.variable_count, right_side);
    sum += terms.chi_square;
  }
  return sum + add_unary(graph, state, right_side, nullptr);
}

double chi_square(const SolverGraph& graph, const SlotPoses& state, std::span<const double> weights,
                  std::vector<double>* each) {
  if (each != nullptr) each->resize(graph.edges.size());
  const std::vector<Point2> directions = directions_of(state);
  double sum = 0.0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const double value = terms_of(graph.edges[e], state, directions, StepSource::state).chi_square;
    if (each != nullptr) (*each)[e] = value;
    sum += weight_of(weights, e) * cauchy_loss(value, graph.edges[e].cauchy_sigmas);
  }
  for (const SolverHeading& heading : graph.headings) {
    sum += cauchy_loss(chi_square(heading, state), heading.cauchy_sigmas);
  }
  return sum;
}

double chi_square(const SolverHeading& heading, const SlotPoses& state) {
  const double error = error_of(heading, state);
  return error * error * heading.information;
}

}  // namespace roomatlas
