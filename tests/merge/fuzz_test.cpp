// SPDX-License-Identifier: GPL-3.0-or-later
// Random polygons, checked by ways that share nothing with the planar map.
#include "merge/dirty_polygons.hpp"
#include "merge/shapes.hpp"
#include "planar/exact_crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include "roomatlas/planar/union.hpp"

namespace roomatlas {
namespace {

using test::total_area;

/// A ring that may cross itself, repeat vertices, run back on itself, and share them with others.
Ring random_ring(std::mt19937& random) {
  std::uniform_int_distribution<int> count(1, 9);
  std::uniform_real_distribution<double> anywhere(0.0, 4.0);
  std::uniform_int_distribution<int> lattice(0, 4);
  std::uniform_int_distribution<int> habit(0, 5);
  Ring ring;
  for (int i = count(random); i > 0; --i) {
    const int h = habit(random);
    if (h == 0 && !ring.empty()) {
      ring.push_back(ring[ring.size() / 2]);
    } else if (h < 4) {
      ring.emplace_back(lattice(random), lattice(random));
    } else {
      ring.emplace_back(anywhere(random), anywhere(random));
    }
  }
  return ring;
}

/// Winding number from angles: slow and independent.
int turns(const Ring& ring, const Point2& point) {
  double angle_rad = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - point;
    const Point2 b = ring[(i + 1) % ring.size()] - point;
    angle_rad += std::atan2(cross(a, b), a.dot(b));
  }
  return static_cast<int>(std::lround(angle_rad / (2.0 * kPi)));
}

bool is_inside_any(const std::vector<Polygon>& polygons, const Point2& point) {
  for (const Polygon& polygon : polygons) {
    if (turns(polygon.outer, point) == 0) continue;
    bool is_in_hole = false;
    for (const Ring& hole : polygon.holes) is_in_hole = is_in_hole || turns(hole, point) != 0;
    if (!is_in_hole) return true;
  }
  return false;
}

constexpr int kCells = 97;
constexpr double kCell_m = 4.0 / kCells;

template <typename Inside>
double raster_area(Inside inside) {
  int count = 0;
  for (int i = 0; i < kCells * kCells; ++i) {
    // off the middle, because edges between lattice points pass through the middles
    const Point2 centre((i % kCells + 0.51234) * kCell_m, (i / kCells + 0.53571) * kCell_m);
    if (inside(centre)) ++count;
  }
  return count * kCell_m * kCell_m;
}

std::vector<Polygon> random_polygons(std::mt19937& random) {
  std::uniform_int_distribution<int> count(1, 5);
  std::bernoulli_distribution has_hole(0.3);
  std::vector<Polygon> polygons;
  for (int i = count(random); i > 0; --i) {
    polygons.push_back({random_ring(random), {}});
    if (has_hole(random)) polygons.back().holes.push_back(random_ring(random));
  }
  return polygons;
}

double perimeter(const std::vector<Polygon>& polygons) {
  double sum = 0.0;
  for (const Polygon& polygon : polygons) {
    sum += length(polygon.outer) + (polygon.outer.back() - polygon.outer.front()).norm();
  }
  return sum;
}

TEST(UnionFuzz, CoversWhatTheWindingNumbersCover) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    const auto polygons = random_polygons(random);
    const auto united = union_of(polygons);
    const double expected =
        raster_area([&](const Point2& p) { return is_inside_any(polygons, p); });
    const double tolerance = 0.02 + 0.2 * kCell_m * perimeter(polygons);
    EXPECT_NEAR(total_area(united), expected, tolerance) << "round " << round;
    const double traced =
        raster_area([&](const Point2& p) { return test::contains_any(united, p); });
    EXPECT_NEAR(traced, expected, 0.02) << "round " << round;
  }
}

TEST(UnionFuzz, KeepsInclusionAndExclusion) {
  std::mt19937 random(2);
  for (int round = 0; round < 400; ++round) {
    const auto first = random_polygons(random);
    const auto second = random_polygons(random);
    auto both = first;
    both.insert(both.end(), second.begin(), second.end());
    const double sum = total_area(union_of(first)) + total_area(union_of(second));
    const double joined = total_area(union_of(both)) + overlap_area(first, second);
    EXPECT_NEAR(joined, sum, 1e-6) << "round " << round;
  }
}

TEST(UnionFuzz, IsIdempotentAndKeepsRingsApart) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const auto united = union_of(random_polygons(random));
    EXPECT_NEAR(total_area(union_of(united)), total_area(united), 0.02) << "round " << round;
    for (const Polygon& polygon : united) {
      EXPECT_GT(signed_area(polygon.outer), 0.0);
      for (const Ring& hole : polygon.holes) {
        EXPECT_LE(signed_area(hole), 1e-9);
        EXPECT_GE(hole.size(), 3U);
      }
    }
  }
}

/// More rounds are a matter of patience: ROOMATLAS_FUZZ=10000 for what the documents state.
int fuzz_rounds() {
  const char* text = std::getenv("ROOMATLAS_FUZZ");
  return text == nullptr ? 400 : std::atoi(text);
}

/// The farthest that a coordinate is from the origin, in metres.
double reach_of(const std::vector<Polygon>& polygons) {
  double reach = 1.0;
  for (const Polygon& polygon : polygons) {
    for (const Point2& point : polygon.outer) reach = std::max(reach, point.cwiseAbs().maxCoeff());
    for (const Ring& hole : polygon.holes) {
      for (const Point2& point : hole) reach = std::max(reach, point.cwiseAbs().maxCoeff());
    }
  }
  return reach;
}

/// What is wrong with rings that should be simple, told by whole numbers; empty: nothing.
/// @param reach_m of the input: decides the grid on which crossings lie.
std::string fault_of(const std::vector<Polygon>& polygons, double reach_m) {
  const double units = std::exp2(std::clamp(49 - std::ilogb(reach_m * 1000.0), 16, 34));
  struct Edge {
    test::FinePoint from, to;
  };
  std::vector<Edge> edges;
  std::string fault;
  const Point2 base = polygons.empty() ? Point2(0, 0) : polygons.front().outer.front();
  const Point2 base_m(std::floor(base.x()), std::floor(base.y()));
  const auto add = [&](const Ring& ring, bool is_outer) {
    if (ring.size() < 3) fault = "a ring of less than three vertices";
    std::vector<test::FinePoint> points;
    for (const Point2& point : ring) points.push_back(test::fine((point - base_m) * 1000.0, units));
    test::Wide doubled = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const test::FinePoint& next = points[(i + 1) % points.size()];
      doubled += test::doubled_area(points[0], points[i], next);
      edges.push_back({points[i], next});
      for (std::size_t j = 0; j < i; ++j) {
        if (points[i] == points[j]) fault = "a ring passes a vertex twice";
      }
    }
    if ((doubled > 0) != is_outer || doubled == 0) fault = "a ring runs the wrong way round";
  };
  for (const Polygon& polygon : polygons) {
    add(polygon.outer, true);
    for (const Ring& hole : polygon.holes) add(hole, false);
  }
  for (const Edge& e : edges) {
    for (const Edge& f : edges) {
      if (test::cross_inside(e.from, e.to, f.from, f.to)) fault = "two edges cross";
      if (test::is_inside_edge(e.from, e.to, f.from)) fault = "a vertex lies on an edge";
    }
  }
  return fault;
}

TEST(UnionFuzz, DirtyPolygonsHaveValidRingsAndTheAreaOfAnIndependentComputation) {
  test::DirtyPolygons dirty(1);
  for (int round = 0; round < fuzz_rounds(); ++round) {
    const auto polygons = dirty.next();
    const auto united = union_of(polygons);
    const double expected_m2 = test::StripArea(polygons).square_metres();
    const double reach_m = reach_of(polygons);
    constexpr double kNothing_m2 = 1e-15;  // what rounding leaves of lines without area
    const double last_bits_m2 = 0x1p-49 * reach_m * perimeter(united);  // of coordinates out there
    EXPECT_NEAR(total_area(united), expected_m2, 1e-6 * expected_m2 + last_bits_m2 + kNothing_m2)
        << "round " << round;
    EXPECT_EQ(fault_of(united, reach_m), "") << "round " << round;
  }
}

TEST(MergeFuzz, ThrowsNothingAndLosesNoFloorOfDirtyPolygons) {
  test::DirtyPolygons dirty(2);
  for (int round = 0; round < fuzz_rounds() / 4; ++round) {
    const auto polygons = dirty.next();
    std::vector<PlacedOutline> outlines;
    for (const Polygon& polygon : polygons) {
      const AsrId asr = static_cast<AsrId>(outlines.size()) + 1;
      outlines.push_back({asr, asr % 3 + 1, polygon});
    }
    const FloorPlan plan = merge(outlines, {}, {.min_part_area_m2 = 0.0});
    const double covered_m2 = total_area(union_of(polygons));
    const double slack_m2 = 1e-6 * covered_m2 + 1e-6;
    EXPECT_GE(total_area(plan.free_space), covered_m2 - slack_m2) << "round " << round;
    const double on_grid_m2 = 1e-3 * perimeter(plan.free_space);  // overlap_area rounds to 1 mm
    EXPECT_LE(overlap_area(plan.free_space, plan.walls), on_grid_m2) << "round " << round;
  }
}

TEST(MergeFuzz, GivesEveryPointToAtMostOneThing) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(0.0, 4.0);
  for (int round = 0; round < 150; ++round) {
    std::vector<PlacedOutline> outlines;
    for (const Polygon& polygon : random_polygons(random)) {
      const AsrId asr = static_cast<AsrId>(outlines.size()) + 1;
      outlines.push_back({asr, asr % 3 + 1, polygon});
    }
    const Point2 jamb(anywhere(random), anywhere(random));
    const Point2 other(anywhere(random), anywhere(random));
    const FloorPlan plan = merge(outlines, {door_between({jamb, other}, 1, 2)}, {});
    double rooms_m2 = 0.0;
    std::vector<Polygon> everything = plan.walls;
    for (const PlanRoom& room : plan.rooms) {
      rooms_m2 += room.area_m2;
      EXPECT_TRUE(contains(room.parts.front(), room.label_point));
      everything.insert(everything.end(), room.parts.begin(), room.parts.end());
    }
    const double opening_m2 = std::abs(signed_area(plan.doors.at(0).opening));
    EXPECT_NEAR(total_area(plan.free_space), rooms_m2 + opening_m2, 1e-3) << "round " << round;
    everything.push_back({plan.doors[0].opening, {}});
    EXPECT_NEAR(total_area(union_of(everything)), total_area(everything), 0.02)
        << "round " << round;
  }
}

}  // namespace
}  // namespace roomatlas
