// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace roomatlas {

void SonarEquations::clear() {
  matrix_.clear();
  right_side_.assign(3 * nodes_, 0.0);
  by_scale_.assign(3 * nodes_, 0.0);
  scale_weight_ = 0.0;
  scale_right_ = 0.0;
}

PairPlaces SonarEquations::places_of(std::size_t first, std::size_t second) const {
  PairPlaces places;
  places.first = position(first);
  places.second = position(second);
  places.of_first = place(places.first, places.first);
  places.of_second = place(places.second, places.second);
  places.of_both =
      place(std::max(places.first, places.second), std::min(places.first, places.second));
  return places;
}

void SonarEquations::add_heading(std::size_t node, double residual, double weight) {
  const std::size_t at = position(node);
  heading_of(place(at, at)) += weight;
  right_side_[3 * at + 2] -= weight * residual;
}

void SonarEquations::add_scale(const PairPlaces& places, const PairResidual& residual,
                               double by_scale, double weight) {
  for (std::size_t i = 0; i < 3; ++i) {
    by_scale_[3 * places.first + i] += weight * residual.by_first[i] * by_scale;
    by_scale_[3 * places.second + i] += weight * residual.by_second[i] * by_scale;
  }
  add_scale(residual.value, by_scale, weight);
}

void SonarEquations::add_scale(double residual, double by_scale, double weight) {
  scale_weight_ += weight * by_scale * by_scale;
  scale_right_ -= weight * residual * by_scale;
}

void SonarEquations::hold(std::size_t node, double weight) {
  const BlockPlace block = place(position(node), position(node));
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> unit{};
    unit[i] = 1.0;
    add_square(block, unit, weight);
  }
}

double SonarEquations::solve(std::vector<Pose2>& map_from_node, double& length_scale) {
  if (matrix_.factorize() != -1) return -1.0;
  matrix_.solve(right_side_.data());
  length_scale += eliminate_scale();
  double squares = 0.0;
  for (std::size_t k = 0; k < nodes_; ++k) {
    Pose2& pose = map_from_node[k];
    const double* const step = right_side_.data() + 3 * position(k);
    pose = {pose.x_m + step[0], pose.y_m + step[1], wrap_angle(pose.theta_rad + step[2])};
    squares += step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
  }
  return std::isfinite(squares) ? std::sqrt(squares / static_cast<double>(nodes_)) : -1.0;
}

std::vector<double> SonarEquations::draw_moves(std::mt19937_64& random) const {
  const auto sign = [&] { return (random() >> 63U) != 0 ? 1.0 : -1.0; };  // of variance 1
  std::vector<double> by_position(3 * nodes_);
  for (double& one : by_position) one = sign();
  matrix_.solve_upper(by_position.data());
  const double scale = sign() * scale_sigma_;
  std::vector<double> moves(3 * nodes_);
  for (std::size_t k = 0; k < nodes_; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t from = 3 * position(k) + i;
      moves[3 * k + i] = by_position[from] - scale * node_by_scale_[from];
    }
  }
  return moves;
}

/// The step of the scale by the Schur complement; takes its part out of the nodes' steps.
double SonarEquations::eliminate_scale() {
  node_by_scale_ = by_scale_;
  matrix_.solve(node_by_scale_.data());
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  };
  const double information = scale_weight_ - dot(by_scale_, node_by_scale_);
  const double step = (scale_right_ - dot(by_scale_, right_side_)) / information;
  scale_sigma_ = 1.0 / std::sqrt(information);
  for (std::size_t i = 0; i < right_side_.size(); ++i) right_side_[i] -= step * node_by_scale_[i];
  return step;
}

}  // namespace roomatlas
