// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/draft/label_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace roomatlas {
namespace {

struct Case {
  std::vector<LabelCosts> cells;
  std::vector<LabelBorder> borders;
};

Case random_case(std::mt19937& random, int cells, int labels) {
  std::uniform_real_distribution<double> cost(0.0, 3.0);
  Case made;
  for (int i = 0; i < cells; ++i) {
    LabelCosts costs{cost(random), 4.0, {}};
    for (int label = 1; label < labels; ++label) costs.rooms[label] = cost(random);
    made.cells.push_back(costs);
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = i + 1; j < cells; ++j) {
      if (random() % 2U == 0U) made.borders.push_back({i, j, cost(random) / 2.0, cost(random)});
    }
  }
  return made;
}

/// The least cost over all labellings.
double least_by_trying(const Case& of, int labels) {
  std::vector<int> label(of.cells.size(), 0);
  double least = labelling_cost(of.cells, of.borders, label);
  while (true) {
    std::size_t at = 0;
    while (at < label.size() && ++label[at] == labels) label[at++] = 0;
    if (at == label.size()) return least;
    least = std::min(least, labelling_cost(of.cells, of.borders, label));
  }
}

TEST(LabelCells, FindsTheCheapestOfTwoLabels) {
  std::mt19937 random(3);
  for (int i = 0; i < 30; ++i) {
    const Case one = random_case(random, 9, 2);
    const std::vector<int> found = label_cells(one.cells, one.borders, 2, 3);
    EXPECT_NEAR(labelling_cost(one.cells, one.borders, found), least_by_trying(one, 2), 1e-3);
  }
}

TEST(LabelCells, IsNearTheCheapestOfManyLabels) {
  std::mt19937 random(5);
  int exact = 0;
  for (int i = 0; i < 30; ++i) {
    const Case one = random_case(random, 7, 4);
    const double found =
        labelling_cost(one.cells, one.borders, label_cells(one.cells, one.borders, 4, 5));
    const double least = least_by_trying(one, 4);
    EXPECT_LE(found, 2.0 * least + 1e-3);  // what alpha expansion guarantees for metrics
    if (found < least + 1e-3) ++exact;
  }
  EXPECT_GE(exact, 24);
}

TEST(LabelCells, ABorderThatCostsMoreThanTheCellsIsNotDrawn) {
  const std::vector<LabelCosts> cells = {{0.0, 9.0, {{1, 1.0}}}, {1.0, 9.0, {{1, 0.0}}}};
  EXPECT_EQ(label_cells(cells, {{0, 1, 0.5, 0.5}}, 2, 3), (std::vector<int>{0, 1}));
  const std::vector<int> joined = label_cells(cells, {{0, 1, 1.5, 1.5}}, 2, 3);
  EXPECT_EQ(joined[0], joined[1]);
}

}  // namespace
}  // namespace roomatlas
