// SPDX-License-Identifier: GPL-3.0-or-later
#include "covariance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dense_product.hpp"
#include "index.hpp"

namespace roomatlas {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Ref;

}  // namespace

/// Copies the inverse at the supernode's rows, which are eliminated later, to the lower right of
/// the front, both halves.
void SelectedInverse::gather(std::size_t s) {
  const Index width = Index{nodes_.width(s)} * 3;
  const Index rows = nodes_.row_count(s);
  const Index stride = width + rows * 3;
  const std::int32_t* const row = nodes_.rows.data() + nodes_.rows_begin[s];
  Eigen::Map<MatrixXd> later(front_.data(), stride, stride);
  for (Index c = 0; c < rows; ++c) {
    const auto owner = at(nodes_.owner[at(row[c])]);
    const Index width_there = nodes_.width(owner);
    const Index stride_there = (width_there + nodes_.row_count(owner)) * 3;
    const double* const column = values_.data() + nodes_.panel_begin[owner] * 9 +
                                 Index{row[c] - nodes_.first[owner]} * 3 * stride_there;
    Index in_owner = 0;  // rows ascend in both
    for (Index r = c; r < rows; ++r) {
      if (row[r] < nodes_.first[owner + 1]) {
        in_owner = row[r] - nodes_.first[owner];
      } else {
        in_owner = std::max(in_owner, width_there);
        while (nodes_.rows[at(nodes_.rows_begin[owner] + in_owner - width_there)] != row[r]) {
          ++in_owner;
        }
      }
      const Eigen::Map<const Eigen::Matrix3d, 0, Eigen::OuterStride<>> block(
          column + in_owner * 3, Eigen::OuterStride<>(stride_there));
      later.block<3, 3>(width + r * 3, width + c * 3) = block;
      later.block<3, 3>(width + c * 3, width + r * 3) = block.transpose();
    }
  }
}

/// A few columns at a time, the last first. With the factor's columns [L11; L21] and
/// Y = L21 inverse(L11), and Z22 the inverse at all rows below them:
///   Z21 = -Z22 Y,  Z11 = inverse(L11 L11') - Y' Z21
void SelectedInverse::invert(const BlockCholesky<3>& factor, std::size_t s) {
  constexpr Index kChunk = 24;  // eight nodes: fewer make small products, more spoil the cache
  const Index width = Index{nodes_.width(s)} * 3;
  const Index stride = width + Index{nodes_.row_count(s)} * 3;
  gather(s);
  const Eigen::Map<const MatrixXd> panel(factor.values() + nodes_.panel_begin[s] * 9, stride,
                                         width);
  Eigen::Map<MatrixXd> front(front_.data(), stride, stride);
  for (Index end = width; end > 0; end = std::max(end - kChunk, Index{0})) {
    const Index begin = std::max(end - kChunk, Index{0});
    const Index own = end - begin;
    const Index below = stride - end;
    const MatrixXd inverse = panel.block(begin, begin, own, own)
                                 .triangularView<Eigen::Lower>()
                                 .solve(MatrixXd::Identity(own, own));
    auto corner = front.block(begin, begin, own, own);
    corner.noalias() = inverse.transpose() * inverse;
    if (below == 0) continue;
    MatrixXd y_transposed(own, below);
    y_transposed.noalias() = inverse.transpose() * panel.block(end, begin, below, own).transpose();
    auto side = front.block(end, begin, below, own);
    side.setZero();
    double* const lower_right = front_.data() + end * stride + end;
    subtract_product({front_.data() + begin * stride + end, stride}, {lower_right, stride},
                     {y_transposed.data(), own}, below, own, below);
    corner.noalias() -= y_transposed * side;
    front.block(begin, end, own, below) = side.transpose();
  }
  Eigen::Map<MatrixXd>(values_.data() + nodes_.panel_begin[s] * 9, stride, width) =
      front.leftCols(width);
}

SelectedInverse::SelectedInverse(const BlockCholesky<3>& factor)
    : nodes_(factor.nodes()), values_(at(factor.nodes().panel_begin.back() * 9)) {
  std::size_t most = 0;
  for (std::size_t s = 0; s < nodes_.size(); ++s) {
    most = std::max(most, at(nodes_.width(s) + nodes_.row_count(s)) * 3);
  }
  front_.resize(most * most);
  for (std::size_t s = nodes_.size(); s-- > 0;) invert(factor, s);
  std::vector<double>().swap(front_);
}

Eigen::Matrix3d SelectedInverse::block(std::int32_t row, std::int32_t column) const {
  const auto count = static_cast<std::int32_t>(nodes_.position.size());
  if (row >= count || column >= count) return Eigen::Matrix3d::Zero();
  if (row < column) return block(column, row).transpose();
  const auto s = at(nodes_.owner[at(column)]);
  const Index stride = (Index{nodes_.width(s)} + nodes_.row_count(s)) * 3;
  const double* const first = values_.data() + nodes_.panel_begin[s] * 9 +
                              Index{column - nodes_.first[s]} * 3 * stride +
                              Index{nodes_.row_in_front(s, row)} * 3;
  return Eigen::Map<const Eigen::Matrix3d, 0, Eigen::OuterStride<>>(first,
                                                                    Eigen::OuterStride<>(stride));
}

Eigen::Matrix3d SelectedInverse::relative(const SlotPoses& state, std::int32_t from,
                                          std::int32_t to) const {
  const double* const a = state.data() + std::ptrdiff_t{from} * 3;
  const double* const b = state.data() + std::ptrdiff_t{to} * 3;
  const double c = std::cos(a[2]);
  const double s = std::sin(a[2]);
  Eigen::Matrix3d turn;
  turn << c, s, 0, -s, c, 0, 0, 0, 1;
  Eigen::Matrix3d step = Eigen::Matrix3d::Identity();
  step(0, 2) = -(b[1] - a[1]);
  step(1, 2) = b[0] - a[0];
  const Eigen::Matrix3d by_to = turn;
  const Eigen::Matrix3d by_from = -turn * step;
  const Eigen::Matrix3d cross = by_from * block(from, to) * by_to.transpose();
  return by_from * block(from, from) * by_from.transpose() +
         by_to * block(to, to) * by_to.transpose() + cross + cross.transpose();
}

PoseCovariance covariance_of(const PoseGraph& poses, LeastSquares& squares, const SlotPoses& state,
                             std::span<const double> weights) {
  const SolverGraph& graph = squares.graph();
  PoseCovariance result;
  const Eigen::Matrix3d unknown =
      Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  result.of_node.assign(graph.slot.size(), unknown);
  result.of_edge.assign(poses.edges.size(), unknown);
  if (!squares.block_solver().factorize_at(state, weights)) return result;
  const SelectedInverse inverse(squares.block_solver().matrix());
  for (std::size_t i = 0; i < graph.slot.size(); ++i) {
    result.of_node[i] = inverse.block(graph.slot[i], graph.slot[i]);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    result.of_edge[at(graph.edge_index[e])] =
        inverse.relative(state, graph.edges[e].from, graph.edges[e].to);
  }
  return result;
}

}  // namespace roomatlas
