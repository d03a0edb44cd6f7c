// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_equations.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "roomatlas/core/mixed_bits.hpp"

namespace roomatlas {

void SonarEquations::clear() {
  matrix_.clear();
  const auto rows = static_cast<Eigen::Index>(3 * nodes_);
  right_side_.assign(static_cast<std::size_t>(rows + shared_), 0.0);
  wild_right_.setZero(signs_.size(), signs_.size() > 0 ? rows + shared_ : 0);
  by_shared_.setZero(rows, shared_);
  shared_weight_.setZero(shared_, shared_);
}

void SonarEquations::begin(ResidualKind kind, std::size_t first, std::size_t second) {
  if (signs_.size() == 0) return;
  const std::size_t low = std::min(first, second) / kClusterNodes;
  const std::size_t high = std::max(first, second) / kClusterNodes;
  std::uint64_t bits =
      mixed_bits(mixed_bits(mixed_bits(static_cast<std::uint64_t>(kind)) + low) + high);
  for (double& sign : signs_) {
    sign = (bits & 1U) != 0 ? 1.0 : -1.0;
    bits >>= 1U;
  }
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

void SonarEquations::add_heading(std::size_t node, std::size_t direction, double residual,
                                 double weight) {
  const std::size_t at = position(node);
  heading_of(place(at, at)) += weight;
  pull(3 * at + 2, -weight * residual);
  if (direction == 0) return;
  const auto column = static_cast<Eigen::Index>(direction);
  by_shared_(static_cast<Eigen::Index>(3 * at + 2), column) -= weight;
  add_direction(direction, -residual, weight);
}

void SonarEquations::add_direction(std::size_t direction, double residual, double weight) {
  const auto column = static_cast<Eigen::Index>(direction);
  shared_weight_(column, column) += weight;
  pull(3 * nodes_ + direction, -weight * residual);
}

void SonarEquations::add_scale(const PairPlaces& places, const PairResidual& residual,
                               double by_scale, double weight) {
  for (std::size_t i = 0; i < 3; ++i) {
    by_shared_(static_cast<Eigen::Index>(3 * places.first + i), kScale) +=
        weight * residual.by_first[i] * by_scale;
    by_shared_(static_cast<Eigen::Index>(3 * places.second + i), kScale) +=
        weight * residual.by_second[i] * by_scale;
  }
  add_scale(residual.value, by_scale, weight);
}

void SonarEquations::add_scale(double residual, double by_scale, double weight) {
  shared_weight_(kScale, kScale) += weight * by_scale * by_scale;
  pull(3 * nodes_ + kScale, -weight * residual * by_scale);
}

void SonarEquations::hold(std::size_t node, double weight) {
  const BlockPlace block = place(position(node), position(node));
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> unit{};
    unit[i] = 1.0;
    add_square(block, unit, weight);
  }
}

double SonarEquations::solve(std::vector<Pose2>& map_from_node, SharedUnknowns& shared) {
  if (matrix_.factorize() != -1) return -1.0;
  eliminate_shared();
  solve_right(right_side_.data());
  const double* const shared_step = right_side_.data() + 3 * nodes_;
  shared.length_scale += shared_step[kScale];
  for (std::size_t i = 1; i < shared.directions_rad.size(); ++i) {
    shared.directions_rad[i] += shared_step[i];
  }
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
  Eigen::VectorXd drawn(shared_);
  for (double& one : drawn) one = sign();
  Eigen::Map<Eigen::VectorXd> moves(by_position.data(), by_shared_.rows());
  moves -= node_by_shared_ * (shared_covariance_.llt().matrixL() * drawn);
  return by_node(by_position.data());
}

std::vector<double> SonarEquations::draw_wild(int draw) const {
  Eigen::VectorXd right = wild_right_.row(draw);
  solve_right(right.data());
  return by_node(right.data());
}

std::vector<double> SonarEquations::by_node(const double* by_position) const {
  std::vector<double> values(3 * nodes_);
  for (std::size_t k = 0; k < nodes_; ++k) {
    std::copy_n(by_position + 3 * position(k), 3, values.data() + 3 * k);
  }
  return values;
}

void SonarEquations::eliminate_shared() {
  node_by_shared_ = by_shared_;
  for (Eigen::Index i = 0; i < shared_; ++i) matrix_.solve(node_by_shared_.col(i).data());
  const Eigen::MatrixXd information = shared_weight_ - by_shared_.transpose() * node_by_shared_;
  shared_covariance_ = information.ldlt().solve(Eigen::MatrixXd::Identity(shared_, shared_));
}

/// What is shared by the Schur complement; its part is taken out of the nodes' steps.
void SonarEquations::solve_right(double* right) const {
  matrix_.solve(right);
  Eigen::Map<Eigen::VectorXd> nodes(right, by_shared_.rows());
  Eigen::Map<Eigen::VectorXd> shared(right + by_shared_.rows(), shared_);
  shared = (shared_covariance_ * (shared - by_shared_.transpose() * nodes)).eval();
  nodes -= node_by_shared_ * shared;
}

}  // namespace roomatlas
