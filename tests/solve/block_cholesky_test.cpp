// SPDX-License-Identifier: GPL-3.0-or-later
// The sparse factorisation against Eigen's dense one.
#include "roomatlas/solve/block_cholesky.hpp"
#include "roomatlas/correct/place.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <set>

#include "../../src/solve/covariance.hpp"
#include "support/false_loops.hpp"

namespace roomatlas {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct System {
  std::size_t nodes = 0;
  std::vector<NodePair> pairs;
};

/// A chain with some far pairs, so that panels of many widths arise.
System random_system(std::size_t nodes, std::size_t more, std::uint64_t seed) {
  test::Dice dice(seed);
  System system{nodes, {}};
  const auto n = static_cast<std::int32_t>(nodes);
  for (std::int32_t i = 1; i < n; ++i) system.pairs.emplace_back(i - 1, i);
  for (std::size_t k = 0; k < more; ++k) system.pairs.emplace_back(dice.below(n), dice.below(n));
  return system;
}

/// Random blocks on the pattern, made positive definite by the diagonal; in order of elimination.
template <int Size>
MatrixXd fill(const System& system, BlockCholesky<Size>& matrix, std::uint64_t seed) {
  test::Dice dice(seed);
  matrix.clear();
  const auto n = static_cast<Index>(system.nodes);
  MatrixXd dense = MatrixXd::Identity(n * Size, n * Size) * 40.0;
  const auto& position = matrix.nodes().position;
  for (const auto& [a, b] : system.pairs) {
    if (a == b) continue;
    const Index row = position[static_cast<std::size_t>(std::max(a, b))];
    const Index column = position[static_cast<std::size_t>(std::min(a, b))];
    for (Index i = 0; i < Size; ++i) {
      for (Index j = 0; j < Size; ++j) {
        const double value = dice.normal();
        dense(row * Size + i, column * Size + j) += value;
        dense(column * Size + j, row * Size + i) += value;
      }
    }
  }
  for (std::int32_t c = 0; c < n; ++c) {
    for (std::int32_t r = c; r < n; ++r) {
      const MatrixXd block = dense.block(r * Size, c * Size, Size, Size);
      if (block.isZero()) continue;
      const BlockPlace place = matrix.place(r, c);
      for (Index j = 0; j < Size; ++j) {
        for (Index i = 0; i < Size; ++i) {
          matrix.values()[place.offset + i + j * place.stride] = block(i, j);
        }
      }
    }
  }
  return dense;
}

template <int Size>
void expect_solves_like_dense(const System& system) {
  const Supernodes nodes = find_supernodes(system.nodes, system.pairs);
  BlockCholesky<Size> matrix(nodes);
  const MatrixXd dense = fill(system, matrix, 7);
  ASSERT_EQ(matrix.factorize(), -1);
  VectorXd x = VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
  const VectorXd expected = dense.llt().solve(x);
  matrix.solve(x.data());
  EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());
}

TEST(BlockCholesky, SolvesLikeADenseFactorisation) {
  for (const auto& [nodes, more] : {std::pair{1, 0}, {2, 0}, {7, 3}, {40, 20}, {120, 300}}) {
    const System system =
        random_system(static_cast<std::size_t>(nodes), static_cast<std::size_t>(more), 3);
    expect_solves_like_dense<1>(system);
    expect_solves_like_dense<2>(system);
    expect_solves_like_dense<3>(system);
    expect_solves_like_dense<4>(system);
  }
}

TEST(BlockCholesky, SolvesTheUpperHalfLikeADenseFactor) {
  const System system = random_system(40, 20, 9);
  const Supernodes nodes = find_supernodes(system.nodes, system.pairs);
  BlockCholesky<3> matrix(nodes);
  const MatrixXd dense = fill(system, matrix, 4);
  ASSERT_EQ(matrix.factorize(), -1);
  VectorXd x = VectorXd::LinSpaced(dense.rows(), -1.0, 2.0);
  const VectorXd expected = dense.llt().matrixU().solve(x);
  matrix.solve_upper(x.data());
  EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());
}

TEST(BlockCholesky, HandlesPartsThatAreNotConnected) {
  expect_solves_like_dense<3>({9, {{0, 1}, {1, 2}, {5, 6}, {6, 7}, {5, 7}}});
}

TEST(BlockCholesky, NamesTheFirstPositionThatIsSingular) {
  const System system = random_system(30, 10, 5);
  const Supernodes nodes = find_supernodes(system.nodes, system.pairs);
  BlockCholesky<3> matrix(nodes);
  (void)fill(system, matrix, 5);
  const BlockPlace place = matrix.place(12, 12);
  matrix.values()[place.offset] = -1.0;
  EXPECT_EQ(matrix.factorize(), 12);
}

TEST(Supernodes, EveryNodeHasItsOwnPosition) {
  const System system = random_system(200, 150, 11);
  const Supernodes nodes = find_supernodes(system.nodes, system.pairs);
  EXPECT_EQ(std::set<int>(nodes.position.begin(), nodes.position.end()).size(), 200U);
  EXPECT_EQ(nodes.first.back(), 200);
}

TEST(SelectedInverse, IsTheInverseWhereTheMatrixHasBlocks) {
  const System system = random_system(60, 80, 9);
  const Supernodes nodes = find_supernodes(system.nodes, system.pairs);
  BlockCholesky<3> matrix(nodes);
  const MatrixXd inverse = fill(system, matrix, 9).inverse();
  ASSERT_EQ(matrix.factorize(), -1);
  const SelectedInverse selected(matrix);
  for (const auto& [a, b] : system.pairs) {
    const auto row = nodes.position[static_cast<std::size_t>(a)];
    const auto column = nodes.position[static_cast<std::size_t>(b)];
    const Eigen::Matrix3d expected = inverse.block<3, 3>(row * 3, column * 3);
    EXPECT_LT((selected.block(row, column) - expected).norm(), 1e-12);
    EXPECT_LT((selected.block(row, row) - inverse.block<3, 3>(row * 3, row * 3)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace roomatlas
