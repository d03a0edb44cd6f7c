// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/store/store_samples.hpp"

namespace roomatlas {

inline Assembly sample_assembly(const Correction& correction, const FloorPlan& plan,
                                const std::map<AsrId, RoomId>& room_of_asr = {},
                                const Paths& paths = {}) {
  Assembly assembly;
  assembly.correction = correction;
  assembly.plan = plan;
  assembly.room_of_asr = room_of_asr;
  assembly.paths = paths;
  return assembly;
}

inline void expect_same(const Correction& a, const Correction& b) {
  EXPECT_EQ(a.converged, b.converged);
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.initial_cost, b.initial_cost);
  EXPECT_EQ(a.final_cost, b.final_cost);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.odometry.habits, b.odometry.habits);
  EXPECT_EQ(a.odometry.asrs, b.odometry.asrs);
  ASSERT_EQ(a.asrs.size(), b.asrs.size());
  for (std::size_t i = 0; i < a.asrs.size(); ++i) {
    EXPECT_EQ(a.asrs[i].asr, b.asrs[i].asr);
    EXPECT_EQ(a.asrs[i].component, b.asrs[i].component);
    EXPECT_EQ(a.asrs[i].building_from_asr_before, b.asrs[i].building_from_asr_before);
    EXPECT_EQ(a.asrs[i].building_from_asr, b.asrs[i].building_from_asr);
    EXPECT_EQ(a.asrs[i].moved_m, b.asrs[i].moved_m);
    EXPECT_EQ(a.asrs[i].turned_rad, b.asrs[i].turned_rad);
  }
  ASSERT_EQ(a.factors.size(), b.factors.size());
  for (std::size_t i = 0; i < a.factors.size(); ++i) {
    EXPECT_EQ(a.factors[i].kind, b.factors[i].kind);
    EXPECT_EQ(a.factors[i].from, b.factors[i].from);
    EXPECT_EQ(a.factors[i].to, b.factors[i].to);
    EXPECT_EQ(a.factors[i].chi_square_before, b.factors[i].chi_square_before);
    EXPECT_EQ(a.factors[i].chi_square_after, b.factors[i].chi_square_after);
    EXPECT_EQ(a.factors[i].weight, b.factors[i].weight);
  }
}

inline void expect_same(const std::vector<Polygon>& a, const std::vector<Polygon>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

inline void expect_same(const PlanRoom& a, const PlanRoom& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind);
  expect_same(a.parts, b.parts);
  EXPECT_EQ(a.area_m2, b.area_m2);
  EXPECT_EQ(a.label_point, b.label_point);
  EXPECT_EQ(a.asrs, b.asrs);
}

inline void expect_same(const PlanDoor& a, const PlanDoor& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.jambs.a, b.jambs.a);
  EXPECT_EQ(a.jambs.b, b.jambs.b);
  EXPECT_EQ(a.width_m, b.width_m);
  EXPECT_EQ(a.opening, b.opening);
  EXPECT_EQ(a.room_a, b.room_a);
  EXPECT_EQ(a.room_b, b.room_b);
  EXPECT_EQ(a.kind, b.kind);
  ASSERT_EQ(a.leaf.has_value(), b.leaf.has_value());
  if (!a.leaf) return;
  EXPECT_EQ(a.leaf->a, b.leaf->a);
  EXPECT_EQ(a.leaf->b, b.leaf->b);
}

inline void expect_same(const std::vector<PlanEdge>& a, const std::vector<PlanEdge>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].room, b[i].room);
    EXPECT_EQ(a[i].line.a, b[i].line.a);
    EXPECT_EQ(a[i].line.b, b[i].line.b);
    EXPECT_EQ(a[i].evidence, b[i].evidence);
    EXPECT_EQ(a[i].deviation_m, b[i].deviation_m);
  }
}

inline void expect_same(const FloorPlan& a, const FloorPlan& b) {
  EXPECT_EQ(a.title, b.title);
  ASSERT_EQ(a.rooms.size(), b.rooms.size());
  for (std::size_t i = 0; i < a.rooms.size(); ++i) expect_same(a.rooms[i], b.rooms[i]);
  ASSERT_EQ(a.doors.size(), b.doors.size());
  for (std::size_t i = 0; i < a.doors.size(); ++i) expect_same(a.doors[i], b.doors[i]);
  expect_same(a.walls, b.walls);
  expect_same(a.free_space, b.free_space);
  expect_same(outlines_of(a.furniture), outlines_of(b.furniture));
  for (std::size_t i = 0; i < a.furniture.size(); ++i) {
    EXPECT_EQ(a.furniture[i].kind, b.furniture[i].kind);
  }
  expect_same(a.edges, b.edges);
  ASSERT_EQ(a.issues.size(), b.issues.size());
  for (std::size_t i = 0; i < a.issues.size(); ++i) {
    EXPECT_EQ(a.issues[i].severity, b.issues[i].severity);
    EXPECT_EQ(a.issues[i].file, b.issues[i].file);
    EXPECT_EQ(a.issues[i].line, b.issues[i].line);
    EXPECT_EQ(a.issues[i].field, b.issues[i].field);
    EXPECT_EQ(a.issues[i].message, b.issues[i].message);
  }
}

}  // namespace roomatlas
