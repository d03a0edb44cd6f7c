// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "polyline/drawing.hpp"

namespace roomatlas {
namespace {

using namespace testing_polyline;

constexpr CellFrame kUnit{1.0};  ///< cells of 1 m: areas are counts

std::vector<CellBoundary> boundaries_of(const Drawing& drawing) {
  return trace_boundaries(mask_of(drawing), kUnit);
}

/// Cells of the mask's box and one cell around it, `inside` or not, in how many components.
int components(const CellMask& mask, bool inside, bool with_corners) {
  const CellBox& box = mask.domain.bounds();
  const CellBox wide{{box.min.x - 1, box.min.y - 1}, {box.max.x + 1, box.max.y + 1}};
  CellMask seen(wide);
  int count = 0;
  for_each_cell(wide, [&](const Cell& start) {
    if (mask.at(start) != inside || seen.at(start)) return;
    ++count;
    std::vector<Cell> open = {start};
    seen.set(start, true);
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      for_each_cell({{at.x - 1, at.y - 1}, {at.x + 2, at.y + 2}}, [&](const Cell& next) {
        const bool is_corner = next.x != at.x && next.y != at.y;
        if (!wide.contains(next) || seen.at(next) || mask.at(next) != inside) return;
        if (is_corner && !with_corners) return;
        seen.set(next, true);
        open.push_back(next);
      });
    }
  });
  return count;
}

/// Checks each edge of each boundary: it lies between a cell of the mask, on the left of the
/// walk, and the outside cell, it was not met before, and it follows on the last one.
void expect_each_edge_once(const CellMask& mask, const std::vector<CellBoundary>& boundaries) {
  std::set<std::pair<double, double>> seen;
  for (const CellBoundary& boundary : boundaries) {
    const Ring& ring = boundary.edge_midpoints;
    ASSERT_EQ(boundary.outside_cells.size(), ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_TRUE(seen.emplace(ring[i].x(), ring[i].y()).second) << "met twice";
      const Cell& outside = boundary.outside_cells[i];
      const Point2 outwards = kUnit.center_of(outside) - ring[i];
      EXPECT_EQ(outwards.norm(), 0.5);
      EXPECT_FALSE(mask.at(outside));
      EXPECT_TRUE(mask.at(kUnit.cell_of(ring[i] - outwards)));
      const Point2 ahead(-outwards.y(), outwards.x());  // half an edge on, with the mask left
      const Point2 on = ring[(i + 1) % ring.size()] - (ring[i] + ahead);
      EXPECT_EQ(on.norm(), 0.5) << "the next edge does not begin where this one ends";
    }
  }
  std::size_t expected = 0;
  for_each_cell(mask.domain, [&](const Cell& c) {
    if (!mask.at(c)) return;
    for (const Cell side : {Cell{c.x + 1, c.y}, {c.x - 1, c.y}, {c.x, c.y + 1}, {c.x, c.y - 1}}) {
      expected += mask.at(side) ? 0 : 1;
    }
  });
  EXPECT_EQ(seen.size(), expected);
}

TEST(TraceBoundaries, GoesCounterClockwiseAroundASingleCell) {
  const auto boundaries = boundaries_of({"...", ".#.", "..."});
  ASSERT_EQ(boundaries.size(), 1U);
  EXPECT_EQ(boundaries[0].edge_midpoints, (Ring{{2, 1.5}, {1.5, 2}, {1, 1.5}, {1.5, 1}}));
  EXPECT_EQ(boundaries[0].outside_cells, (std::vector<Cell>{{2, 1}, {1, 2}, {0, 1}, {1, 0}}));
}

TEST(TraceBoundaries, GoesClockwiseAroundAHole) {
  const auto boundaries = boundaries_of({"####",  //
                                         "#..#",  //
                                         "####"});
  ASSERT_EQ(boundaries.size(), 2U);
  EXPECT_EQ(boundaries[0].edge_midpoints.size(), 14U);
  EXPECT_EQ(boundaries[1].edge_midpoints.size(), 6U);
  // The ring of midpoints cuts a triangle of 1/8 off each of the four corners.
  EXPECT_DOUBLE_EQ(signed_area(boundaries[0].edge_midpoints), 12.0 - 0.5);
  EXPECT_DOUBLE_EQ(signed_area(boundaries[1].edge_midpoints), -(2.0 - 0.5));
}

TEST(TraceBoundaries, PassesBetweenCellsThatTouchAtACornerAlone) {
  const auto boundaries = boundaries_of({".#", "#."});
  ASSERT_EQ(boundaries.size(), 2U);
  EXPECT_DOUBLE_EQ(signed_area(boundaries[0].edge_midpoints), 0.5);
  EXPECT_DOUBLE_EQ(signed_area(boundaries[1].edge_midpoints), 0.5);
}

TEST(TraceBoundaries, TakesHolesThatTouchAtACornerForOne) {
  const auto boundaries = boundaries_of({"####",  //
                                         "#.##",  //
                                         "##.#",  //
                                         "####"});
  ASSERT_EQ(boundaries.size(), 2U);
  EXPECT_EQ(boundaries[1].edge_midpoints.size(), 8U);
  EXPECT_LT(signed_area(boundaries[1].edge_midpoints), 0.0);
}

TEST(TraceBoundaries, ClosesAroundAMaskThatFillsItsBox) {
  const auto boundaries = boundaries_of({"###", "###"});
  ASSERT_EQ(boundaries.size(), 1U);
  EXPECT_EQ(boundaries[0].edge_midpoints.size(), 10U);
  EXPECT_DOUBLE_EQ(signed_area(boundaries[0].edge_midpoints), 5.5);
}

TEST(TraceBoundaries, MeasuresInMetresFromTheFramesOrigin) {
  CellMask mask({{-3, 4}, {-1, 6}});
  mask.set({-2, 5}, true);
  const auto boundaries = trace_boundaries(mask, CellFrame{0.1});
  ASSERT_EQ(boundaries.size(), 1U);
  EXPECT_LT((boundaries[0].edge_midpoints[0] - Point2(-0.1, 0.55)).norm(), 1e-12);
}

TEST(TraceBoundaries, VisitsEachBoundaryEdgeOnceWithTheMaskOnItsLeft) {
  std::mt19937 random(61);
  for (const std::string letters : {"#.", "####.", "#...."}) {
    for (int round = 0; round < 20; ++round) {
      const CellMask mask = mask_of(random_drawing(random, 19, 13, letters));
      expect_each_edge_once(mask, trace_boundaries(mask, kUnit));
    }
  }
}

TEST(TraceBoundaries, EnclosesTheCountOfCellsLessTheCornersThatMidpointsCut) {
  // A simple ring of cell edges has four left turns more than right turns, a hole four fewer;
  // each turn is a triangle of 1/8. So every ring of midpoints lacks half a cell.
  std::mt19937 random(62);
  for (const std::string letters : {"#.", "####.", "#...."}) {
    for (int round = 0; round < 20; ++round) {
      const CellMask mask = mask_of(random_drawing(random, 19, 13, letters));
      int outer = 0;
      int holes = 0;
      double area = 0.0;
      for (const CellBoundary& boundary : trace_boundaries(mask, kUnit)) {
        const double signed_area_of_ring = signed_area(boundary.edge_midpoints);
        (signed_area_of_ring > 0.0 ? outer : holes) += 1;
        area += signed_area_of_ring;
      }
      EXPECT_EQ(outer, components(mask, true, false));
      EXPECT_EQ(holes, components(mask, false, true) - 1);
      EXPECT_NEAR(area, static_cast<double>(mask.count()) - 0.5 * (outer - holes), 1e-9);
    }
  }
}

TEST(TraceBoundaries, OfAnEmptyMaskAreNone) {
  EXPECT_TRUE(boundaries_of({"...", "..."}).empty());
  EXPECT_TRUE(boundaries_of({}).empty());
}

}  // namespace
}  // namespace roomatlas
