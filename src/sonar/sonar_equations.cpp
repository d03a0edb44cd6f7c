// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_equations.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace roomatlas {

void SonarEquations::clear() {
  matrix_.clear();
  right_side_.assign(3 * nodes_, 0.0);
  by_shared_.setZero(static_cast<Eigen::Index>(3 * nodes_), shared_);
  shared_weight_.setZero(shared_, shared_);
  shared_right_.setZero(shared_);
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
  right_side_[3 * at + 2] -= weight * residual;
  if (direction == 0) return;
  const auto column = static_cast<Eigen::Index>(direction);
  by_shared_(static_cast<Eigen::Index>(3 * at + 2), column) -= weight;
  add_direction(direction, -residual, weight);
}

void SonarEquations::add_direction(std::size_t direction, double residual, double weight) {
  const auto column = static_cast<Eigen::Index>(direction);
  shared_weight_(column, column) += weight;
  shared_right_(column) -= weight * residual;
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
  shared_right_(kScale) -= weight * residual * by_scale;
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
  matrix_.solve(right_side_.data());
  const Eigen::VectorXd moved = eliminate_shared();
  shared.length_scale += moved(kScale);
  for (std::size_t i = 1; i < shared.directions_rad.size(); ++i) {
    shared.directions_rad[i] += moved(static_cast<Eigen::Index>(i));
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
  const Eigen::VectorXd by_shared = node_by_shared_ * (shared_covariance_.llt().matrixL() * drawn);
  std::vector<double> moves(3 * nodes_);
  for (std::size_t k = 0; k < nodes_; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t from = 3 * position(k) + i;
      moves[3 * k + i] = by_position[from] - by_shared(static_cast<Eigen::Index>(from));
    }
  }
  return moves;
}

/// The step of what is shared by the Schur complement; takes its part out of the nodes' steps.
Eigen::VectorXd SonarEquations::eliminate_shared() {
  node_by_shared_ = by_shared_;
  for (Eigen::Index i = 0; i < shared_; ++i) matrix_.solve(node_by_shared_.col(i).data());
  Eigen::Map<Eigen::VectorXd> nodes(right_side_.data(), by_shared_.rows());
  const Eigen::MatrixXd information = shared_weight_ - by_shared_.transpose() * node_by_shared_;
  const Eigen::LDLT<Eigen::MatrixXd> factors(information);
  Eigen::VectorXd step = factors.solve(shared_right_ - by_shared_.transpose() * nodes);
  shared_covariance_ = factors.solve(Eigen::MatrixXd::Identity(shared_, shared_));
  nodes -= node_by_shared_ * step;
  return step;
}

}  // namespace roomatlas
