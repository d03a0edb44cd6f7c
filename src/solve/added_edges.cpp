// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/solve/added_edges.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "index.hpp"

namespace roomatlas {
namespace {

using Eigen::Index;
using Jacobian = Eigen::Matrix3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Of an edge's error, in the frame of `to` where the nodes are.
struct Jacobians {
  Jacobian by_from;
  Jacobian by_to;
};

Jacobians jacobians_of(const Pose2& from, const Pose2& to) {
  const Point2 step = to.position() - from.position();
  const Point2 along = direction(to.theta_rad);
  Jacobians j;
  j.by_to << along.x(), along.y(), 0.0, -along.y(), along.x(), 0.0, 0.0, 0.0, 1.0;
  Jacobian carried = Jacobian::Identity();  // a turn of `from` swings `to` around it
  carried(0, 2) = -step.y();
  carried(1, 2) = step.x();
  j.by_from = -j.by_to * carried;
  return j;
}

std::vector<std::int32_t> components_of(const PoseGraph& graph) {
  std::vector<std::int32_t> parent(graph.ids.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t node) {
    while (parent[at(node)] != node) node = parent[at(node)] = parent[at(parent[at(node)])];
    return node;
  };
  for (const PoseEdge& edge : graph.edges) parent[at(root(edge.from))] = root(edge.to);
  std::vector<std::int32_t> component;
  component.reserve(parent.size());
  for (std::int32_t i = 0; i < std::ssize(parent); ++i) component.push_back(root(i));
  return component;
}

/// Rows of what does not move: the position of each component's node of lowest id, and its heading
/// where none is measured in the component.
std::vector<bool> fixed_rows(const PoseGraph& graph) {
  const std::vector<std::int32_t> component = components_of(graph);
  std::vector<std::int32_t> lowest(graph.ids.size(), -1);
  for (std::size_t i = 0; i < component.size(); ++i) {
    std::int32_t& node = lowest[at(component[i])];
    if (node < 0 || graph.ids[i] < graph.ids[at(node)]) node = static_cast<std::int32_t>(i);
  }
  std::vector<bool> has_heading(graph.ids.size(), false);
  for (const HeadingPrior& prior : graph.headings)
    has_heading[at(component[at(prior.node)])] = true;
  std::vector<bool> fixed(3 * graph.ids.size(), false);
  for (std::size_t c = 0; c < lowest.size(); ++c) {
    if (lowest[c] < 0) continue;
    const std::size_t row = 3 * at(lowest[c]);
    fixed[row] = fixed[row + 1] = true;
    fixed[row + 2] = !has_heading[c];
  }
  return fixed;
}

/// What all measurements say of all nodes, as sums of entries.
Triplets information_of(const PoseGraph& graph) {
  Triplets entries;
  const auto add_block = [&](std::int32_t row, std::int32_t column, const Eigen::Matrix3d& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * row + r, 3 * column + c, block(r, c));
    }
  };
  for (const PoseEdge& edge : graph.edges) {
    const Pose2& from = graph.guess[at(edge.from)];
    const Pose2& to = graph.guess[at(edge.to)];
    const Eigen::Matrix3d weighed =
        cauchy_weight(chi_square(edge, from, to), edge.cauchy_sigmas) * edge.information;
    const Jacobians j = jacobians_of(from, to);
    add_block(edge.from, edge.from, j.by_from.transpose() * weighed * j.by_from);
    add_block(edge.from, edge.to, j.by_from.transpose() * weighed * j.by_to);
    add_block(edge.to, edge.from, j.by_to.transpose() * weighed * j.by_from);
    add_block(edge.to, edge.to, j.by_to.transpose() * weighed * j.by_to);
  }
  for (const HeadingPrior& prior : graph.headings) {
    const double weight =
        cauchy_weight(chi_square(prior, graph.guess[at(prior.node)]), prior.cauchy_sigmas);
    entries.emplace_back(3 * prior.node + 2, 3 * prior.node + 2,
                         weight / (prior.sigma_rad * prior.sigma_rad));
  }
  return entries;
}

/// Rows that do not move get a one, and are taken out again once all is inverted.
Eigen::MatrixXd inverse_of(const Triplets& all, const std::vector<bool>& fixed) {
  Triplets entries;
  for (const auto& entry : all) {
    if (!fixed[at(entry.row())] && !fixed[at(entry.col())]) entries.push_back(entry);
  }
  const auto rows = static_cast<Index>(fixed.size());
  for (Index row = 0; row < rows; ++row) {
    if (fixed[at(row)]) entries.emplace_back(static_cast<int>(row), static_cast<int>(row), 1.0);
  }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success || factor.vectorD().minCoeff() <= 0.0) return {};
  Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(rows, rows));
  for (Index row = 0; row < rows; ++row) {
    if (fixed[at(row)]) inverse(row, row) = 0.0;
  }
  return inverse;
}

void enlarge(LargestVariance& largest, const Eigen::Matrix3d& covariance) {
  const double middle = (covariance(0, 0) + covariance(1, 1)) / 2.0;
  const double apart = std::hypot((covariance(0, 0) - covariance(1, 1)) / 2.0, covariance(0, 1));
  largest.position_m2 = std::max(largest.position_m2, middle + apart);
  largest.heading_rad2 = std::max(largest.heading_rad2, covariance(2, 2));
}

}  // namespace

AddedEdges::AddedEdges(const PoseGraph& graph) : at_(graph.guess) {
  if (graph.guess.size() != graph.ids.size()) {
    throw std::invalid_argument("AddedEdges: the pose graph has not one guess a node");
  }
  covariance_ = inverse_of(information_of(graph), fixed_rows(graph));
}

AddedEdges::AddedEdges(std::vector<Pose2> at, const std::vector<std::vector<Pose2>>& moves)
    : at_(std::move(at)) {
  const auto draws = static_cast<Index>(moves.empty() ? 0 : moves.front().size());
  const bool is_even = std::all_of(moves.begin(), moves.end(), [&](const auto& of_node) {
    return static_cast<Index>(of_node.size()) == draws;
  });
  if (moves.size() != at_.size() || !is_even || draws == 0) {
    throw std::invalid_argument("AddedEdges: not as many moves of every node");
  }
  Eigen::MatrixXd sample(3 * static_cast<Index>(moves.size()), draws);  // along the axes of all
  for (std::size_t node = 0; node < moves.size(); ++node) {
    const Point2 along = direction(at_[node].theta_rad);
    for (Index draw = 0; draw < draws; ++draw) {
      const Pose2& move = moves[node][static_cast<std::size_t>(draw)];
      sample.block<3, 1>(3 * static_cast<Index>(node), draw)
          << along.x() * move.x_m - along.y() * move.y_m,
          along.y() * move.x_m + along.x() * move.y_m, move.theta_rad;
    }
  }
  covariance_ = sample * sample.transpose() / static_cast<double>(draws);
}

LargestVariance AddedEdges::now() const { return with({}); }

LargestVariance AddedEdges::with(std::span<const PoseEdge> edges) const {
  const Eigen::MatrixXd taken = reduction(edges);
  LargestVariance largest;
  for (Index row = 0; row < covariance_.rows(); row += 3) {
    Eigen::Matrix3d left = covariance_.block<3, 3>(row, row);
    if (!edges.empty()) {
      const auto part = taken.middleCols<3>(row);
      left.noalias() -= part.transpose() * part;
    }
    enlarge(largest, left);
  }
  return largest;
}

Eigen::Matrix3d AddedEdges::relative(std::int32_t from, std::int32_t to) const {
  const Jacobians j = jacobians_of(at_[at(from)], at_[at(to)]);
  const auto block = [&](std::int32_t row, std::int32_t column) {
    return covariance_.block<3, 3>(Index{3} * row, Index{3} * column);
  };
  const Eigen::Matrix3d cross = j.by_from * block(from, to) * j.by_to.transpose();
  return j.by_from * block(from, from) * j.by_from.transpose() +
         j.by_to * block(to, to) * j.by_to.transpose() + cross + cross.transpose();
}

void AddedEdges::add(std::span<const PoseEdge> edges) {
  if (edges.empty()) return;
  const Eigen::MatrixXd taken = reduction(edges);
  covariance_.noalias() -= taken.transpose() * taken;
}

Eigen::MatrixXd AddedEdges::reduction(std::span<const PoseEdge> edges) const {
  const auto rows = 3 * static_cast<Index>(edges.size());
  Eigen::MatrixXd seen(rows, covariance_.cols());  // the edges' Jacobian times the covariance
  for (Index k = 0; k < std::ssize(edges); ++k) {
    const PoseEdge& edge = edges[at(k)];
    const Jacobians j = jacobians_of(at_[at(edge.from)], at_[at(edge.to)]);
    seen.middleRows<3>(3 * k) = j.by_from * covariance_.middleRows<3>(Index{3} * edge.from) +
                                j.by_to * covariance_.middleRows<3>(Index{3} * edge.to);
  }
  Eigen::MatrixXd expected(rows, rows);  // covariance of what would be measured
  for (Index k = 0; k < std::ssize(edges); ++k) {
    const PoseEdge& edge = edges[at(k)];
    const Jacobians j = jacobians_of(at_[at(edge.from)], at_[at(edge.to)]);
    expected.middleCols<3>(3 * k) =
        seen.middleCols<3>(Index{3} * edge.from) * j.by_from.transpose() +
        seen.middleCols<3>(Index{3} * edge.to) * j.by_to.transpose();
    expected.block<3, 3>(3 * k, 3 * k) +=
        edge.information.ldlt().solve(Eigen::Matrix3d::Identity());
  }
  return expected.llt().matrixL().solve(seen);
}

}  // namespace roomatlas
