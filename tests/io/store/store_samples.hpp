// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/store/geopackage_store.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace roomatlas {

/// A directory of its own for one test, gone afterwards.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "roomatlas-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::shared_ptr<const RangeSensor> sample_sensor(SensorKind kind, int beams) {
  RangeSensor sensor;
  sensor.kind = kind;
  for (int i = 0; i < beams; ++i) sensor.robot_from_beam.push_back({0.1, 0.0, -1.5 + i / 3.0});
  sensor.half_cone_rad = 0.1 / 3.0;
  sensor.max_range_m = 8.0;
  return std::make_shared<const RangeSensor>(sensor);
}

/// An ASR with every field filled, with numbers that have no short decimal form; its neighbours
/// are the ASRs before and after it.
inline Asr sample_asr(AsrId id, int readings = 20) {
  const auto n = static_cast<double>(id);
  Asr asr;
  asr.id = id;
  asr.room = 0;
  asr.start_s = 1054000000.123456 + 10.0 * n;
  asr.end_s = asr.start_s + 9.0 / 7.0;
  asr.odom_from_asr = {n / 3.0, -n / 7.0, 1.0 / n};
  asr.walls = {{{{0.1, 0.2}, {1.0 / 3.0, 4.0}, {5.0, 1e-300}}, {true, false}},
               {{{2.0, 2.0}}, {}},
               {{{7.0, 1.0}, {7.5, -1.0}}, {true}}};
  asr.outline_asr = {{{0, 0}, {6, 0.1}, {6, 5}, {0, 5}},
                     {{{1, 1}, {1, 2}, {2, 2}}, {{3, 3}, {3, 4}, {4, 4}, {4, 3}}}};
  const Segment2 jambs{{0.0, 0.45}, {0.0, -0.45}};
  if (id > 1) {
    asr.exits.push_back(
        {{{0, 0, -kPi}, 0.9, jambs}, PassageKind::doorway, true, id - 1, asr.start_s});
  }
  asr.exits.push_back(
      {{{5.5, n / 9, 0.1}, 0.0, {}}, PassageKind::open_passage, false, id + 1, asr.end_s});
  asr.exits.push_back(
      {{{1.5, 5.0, 1.5}, 0.8, jambs}, PassageKind::doorway, false, std::nullopt, asr.end_s});
  asr.reference_point_asr = {2.0 / 3.0, 2.5};
  asr.is_localized = id % 2 == 1;
  const auto laser = sample_sensor(SensorKind::laser, 9);
  const auto sonar = sample_sensor(SensorKind::sonar, 4);
  for (int i = 0; i < readings; ++i) {
    const double t = asr.start_s + i / 11.0;
    const Pose2 odom{i / 3.0, n + i / 7.0, wrap_angle(i / 5.0)};
    asr.path.push_back({t, {i / 13.0, -i / 17.0, wrap_angle(i / 19.0)}, odom});
    RangeReading reading{t, odom, i % 4 == 0 ? sonar : laser, {}};
    for (std::size_t b = 0; b < reading.sensor->robot_from_beam.size(); ++b) {
      reading.ranges_m.push_back(
          static_cast<float>(0.5 + static_cast<double>(b) * 0.731 + i * 0.01));
    }
    asr.readings.push_back(reading);
  }
  asr.counters = {120 * 80, 9600, 700 + id, 600, 500, 40, 320, 3};
  return asr;
}

inline void expect_same(const Polygon& a, const Polygon& b) {
  EXPECT_EQ(a.outer, b.outer);
  EXPECT_EQ(a.holes, b.holes);
}

inline void expect_same(const Exit& a, const Exit& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.is_entry, b.is_entry);
  EXPECT_EQ(a.frame_from_pivot, b.frame_from_pivot);
  EXPECT_EQ(a.width_m, b.width_m);
  EXPECT_EQ(a.jambs.a, b.jambs.a);
  EXPECT_EQ(a.jambs.b, b.jambs.b);
  EXPECT_EQ(a.neighbor, b.neighbor);
  EXPECT_EQ(a.timestamp_s, b.timestamp_s);
}

inline void expect_same(const PathSample& a, const PathSample& b) {
  EXPECT_EQ(a.timestamp_s, b.timestamp_s);
  EXPECT_EQ(a.asr_from_robot, b.asr_from_robot);
  EXPECT_EQ(a.odom_from_robot, b.odom_from_robot);
}

/// Ranges to 1 mm, all else bit for bit.
inline void expect_same(const RangeReading& a, const RangeReading& b) {
  EXPECT_EQ(a.timestamp_s, b.timestamp_s);
  EXPECT_EQ(a.odom_from_robot, b.odom_from_robot);
  EXPECT_EQ(a.sensor->kind, b.sensor->kind);
  EXPECT_EQ(a.sensor->robot_from_beam, b.sensor->robot_from_beam);
  EXPECT_EQ(a.sensor->half_cone_rad, b.sensor->half_cone_rad);
  EXPECT_EQ(a.sensor->max_range_m, b.sensor->max_range_m);
  ASSERT_EQ(a.ranges_m.size(), b.ranges_m.size());
  for (std::size_t i = 0; i < a.ranges_m.size(); ++i) {
    EXPECT_NEAR(a.ranges_m[i], b.ranges_m[i], 1e-3);
  }
}

inline void expect_same_geometry(const Asr& a, const Asr& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.room, b.room);
  EXPECT_EQ(a.start_s, b.start_s);
  EXPECT_EQ(a.end_s, b.end_s);
  EXPECT_EQ(a.odom_from_asr, b.odom_from_asr);
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t i = 0; i < a.walls.size(); ++i) {
    EXPECT_EQ(a.walls[i].vertices_asr, b.walls[i].vertices_asr);
    EXPECT_EQ(a.walls[i].edge_is_fitted, b.walls[i].edge_is_fitted);
  }
  expect_same(a.outline_asr, b.outline_asr);
  ASSERT_EQ(a.exits.size(), b.exits.size());
  for (std::size_t i = 0; i < a.exits.size(); ++i) expect_same(a.exits[i], b.exits[i]);
  EXPECT_EQ(a.reference_point_asr, b.reference_point_asr);
  EXPECT_EQ(a.is_localized, b.is_localized);
  const AsrCounters& m = a.counters;
  const AsrCounters& n = b.counters;
  EXPECT_EQ(m.grid_cells, n.grid_cells);
  EXPECT_EQ(m.grid_bytes, n.grid_bytes);
  EXPECT_EQ(m.occupied_cells, n.occupied_cells);
  EXPECT_EQ(m.cleaned_cells, n.cleaned_cells);
  EXPECT_EQ(m.extracted_points, n.extracted_points);
  EXPECT_EQ(m.vertices, n.vertices);
  EXPECT_EQ(m.geometry_bytes, n.geometry_bytes);
  EXPECT_EQ(m.ignored_ranges, n.ignored_ranges);
}

inline void expect_same(const Asr& a, const Asr& b) {
  expect_same_geometry(a, b);
  ASSERT_EQ(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < a.path.size(); ++i) expect_same(a.path[i], b.path[i]);
  ASSERT_EQ(a.readings.size(), b.readings.size());
  for (std::size_t i = 0; i < a.readings.size(); ++i) expect_same(a.readings[i], b.readings[i]);
}

/// @param asrs that measurements are between; poses have three at the least, as the stores of these
///   tests have visits
inline Correction sample_correction(AsrId asrs) {
  Correction correction{true,      "se2", "converged after 3 steps",          12.0 / 7.0,
                        1.0 / 7.0, 3,     {{0.0, 1.0 / 60.0, 0.96, 1.0}, 12}, {},
                        {}};
  for (AsrId id = 1; id <= std::max<AsrId>(asrs, 3); ++id) {
    const auto n = static_cast<double>(id);
    correction.asrs.push_back({id, id % 2, {n, 0, 0.1}, {n / 3.0, 1.0 / n, -0.2}, 0.7 * n, -0.3});
    if (id > asrs) continue;
    correction.factors.push_back({FactorKind::odometry, id, id % asrs + 1, 2.0 / 3.0, 0.1, 1.0});
    correction.factors.push_back({FactorKind::wall_direction, id, 0, -1.0, -1.0, 1.0 / 3.0});
  }
  correction.factors.push_back({FactorKind::doorway, 1, asrs, 99.0, 98.0, 0.001});
  correction.factors.push_back({FactorKind::closure, 1, asrs, 5.0 / 3.0, 0.2, 0.9});
  return correction;
}

inline FloorPlan sample_plan() {
  const Polygon ring{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}}};
  const Polygon island{{{20, 1.0 / 3.0}, {21, 0}, {21, 1}}, {}};
  FloorPlan plan;
  plan.title = "Building \"79\" \xc3\xbc";
  plan.rooms = {{1, "Lab 315", RoomKind::hall, {ring, island}, 72.5, {1.5, 1.5}, {1, 4, 2}},
                {2, "2", RoomKind::corridor, {island}, 0.5, {20.6, 0.3}, {}},
                {7, "7", RoomKind::room, {}, 0.0, {0, 0}, {3}}};
  plan.doors = {
      {1, {{9, 4}, {9, 5}}, 1.0, {{9, 4}, {9.15, 4}, {9.15, 5}, {9, 5}}, 1, 2, DoorKind::door, {}},
      {2, {{0, 4}, {0, 5}}, 1.0 / 3.0, {}, std::nullopt, 2, DoorKind::window, {}}};
  plan.doors[0].leaf = Segment2{{9, 4}, {9.0 + 2.0 / 3.0, 4.7}};
  plan.walls = {{{{-0.15, -0.15}, {9.15, -0.15}, {9.15, 9.15}, {-0.15, 9.15}}, {ring.outer}}};
  plan.free_space = {ring, island};
  plan.furniture = {{island, FurnitureKind::free_standing},
                    {{{{1, 1}, {2, 1}, {2, 1.5}}, {}}, FurnitureKind::against_wall}};
  plan.edges = {{1, {{0, 0}, {9, 1e-9}}, WallEvidence::measured, 1.0 / 70.0},
                {1, {{9, 0}, {9, 4}}, WallEvidence::inferred, std::nullopt},
                {2, {{20, 1.0 / 3.0}, {21, 0}}, WallEvidence::unexplored, std::nullopt}};
  plan.issues = {{Severity::warning, "mission.clf", 17, "room 2", "healed a bow-tie"},
                 {Severity::note, "", 0, "", "nothing"}};
  return plan;
}

}  // namespace roomatlas
