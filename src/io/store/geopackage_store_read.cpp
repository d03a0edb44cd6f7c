// SPDX-License-Identifier: GPL-3.0-or-later
#include "geopackage_store_state.hpp"
#include "readings_codec.hpp"
#include "stored_names.hpp"
#include "wkb.hpp"

namespace roomatlas {
namespace {

std::vector<WallPolyline> walls_of(ByteView wkb, const std::string& edges) {
  std::vector<WallPolyline> walls;
  for (Polyline& line : lines_of_wkb(wkb)) walls.push_back({std::move(line), {}});
  std::size_t wall = 0;
  for (const char edge : edges) {
    if (edge == '|') {
      ++wall;
    } else if (wall < walls.size()) {
      walls[wall].edge_is_fitted.push_back(edge == '1');
    }
  }
  return walls;
}

AsrCounters counters_of(Row& row) {
  AsrCounters n;
  for (std::int64_t* counter :
       {&n.grid_cells, &n.grid_bytes, &n.occupied_cells, &n.cleaned_cells, &n.extracted_points,
        &n.vertices, &n.geometry_bytes, &n.ignored_ranges}) {
    *counter = row.integer();
  }
  return n;
}

Asr asr_of(Row& row) {
  Asr asr;
  asr.id = row.integer();
  asr.room = row.integer();
  asr.start_s = row.real();
  asr.end_s = row.real();
  asr.odom_from_asr = row.pose();
  for (double* at : {&asr.reference_point_asr.x(), &asr.reference_point_asr.y()}) *at = row.real();
  asr.outline_asr = polygon_of_wkb(row.blob());
  const ByteView walls = row.blob();
  asr.walls = walls_of(walls, row.text());
  asr.counters = counters_of(row);
  asr.is_localized = row.integer() != 0;
  return asr;
}

Exit exit_of(Row& row) {
  Exit exit;
  exit.kind = value_of_stored_name(kPassageKinds, row.text());
  exit.is_entry = row.flag();
  exit.frame_from_pivot = row.pose();
  exit.width_m = row.real();
  exit.jambs.a = row.point();
  exit.jambs.b = row.point();
  exit.neighbor = row.optional_integer();
  exit.timestamp_s = row.real();
  return exit;
}

std::vector<Exit> exits_of(Database& db, AsrId id) {
  const RowKeys keys = row_keys(id);
  std::vector<Exit> exits;
  db.for_each_row(
      "SELECT kind, is_entry, asr_from_pivot_x_m, asr_from_pivot_y_m, asr_from_pivot_theta_rad, "
      "width_m, left_jamb_x_m, left_jamb_y_m, right_jamb_x_m, right_jamb_y_m, neighbor, "
      "timestamp_s FROM exits WHERE id BETWEEN ? AND ? ORDER BY id",
      [&](Row& row) {
        exits.push_back(exit_of(row));
        if (exits.back().neighbor == id) {
          throw DamagedData("neighbor is the exit's own ASR, expected another one");
        }
      },
      keys.first, keys.last);
  return exits;
}

std::vector<PathSample> path_of(Database& db, AsrId id) {
  const RowKeys keys = row_keys(id);
  std::vector<PathSample> path;
  db.for_each_row(
      "SELECT timestamp_s, asr_from_robot_x_m, asr_from_robot_y_m, asr_from_robot_theta_rad, "
      "odom_from_robot_x_m, odom_from_robot_y_m, odom_from_robot_theta_rad "
      "FROM path_samples WHERE id BETWEEN ? AND ? ORDER BY id",
      [&](Row& row) {
        PathSample sample;
        sample.timestamp_s = row.real();
        sample.asr_from_robot = row.pose();
        sample.odom_from_robot = row.pose();
        path.push_back(sample);
      },
      keys.first, keys.last);
  return path;
}

/// Puts the poses at which readings were matched again into a path.
void take_matched_path(Database& db, Asr& asr) {
  const RowKeys keys = row_keys(asr.id);
  std::size_t i = 0;
  db.for_each_row(
      "SELECT asr_from_robot_x_m, asr_from_robot_y_m, asr_from_robot_theta_rad "
      "FROM matched_path WHERE id BETWEEN ? AND ? ORDER BY id",
      [&](Row& row) {
        if (i == asr.path.size()) throw DamagedData("matched_path has more rows than path_samples");
        asr.path[i++].asr_from_robot = row.pose();
      },
      keys.first, keys.last);
}

void require_a_range_a_beam(const RangeReading& reading) {
  const std::size_t beams = reading.sensor->robot_from_beam.size();
  if (reading.ranges_m.size() == beams) return;
  throw DamagedData("a reading has " + std::to_string(reading.ranges_m.size()) +
                    " ranges, expected " + std::to_string(beams) + ", as its sensor has beams");
}

std::vector<RangeReading> readings_of(Database& db, SensorTable& sensors, const Asr& asr) {
  std::vector<RangeReading> readings;
  db.for_each_row(
      "SELECT reading_count, raw_bytes, deflated FROM readings WHERE asr = ?",
      [&](Row& row) {
        PackedReadings packed;
        packed.count = row.integer();
        packed.raw_bytes = row.integer();
        const ByteView deflated = row.blob();
        packed.deflated.assign(deflated.begin(), deflated.end());
        readings =
            unpack_readings(packed, asr.path, [&](std::int64_t id) { return sensors.get(db, id); });
        for (const RangeReading& reading : readings) require_a_range_a_beam(reading);
      },
      asr.id);
  return readings;
}

}  // namespace

std::vector<AsrId> GeoPackageStore::ids() const {
  return state_->reading([](Database& db) {
    std::vector<AsrId> ids;
    db.for_each_row("SELECT id FROM asr ORDER BY id",
                    [&](Row& row) { ids.push_back(row.integer()); });
    return ids;
  });
}

Asr GeoPackageStore::get(AsrId id, AsrDetail detail) const {
  return state_->reading([&](Database& db) {
    Asr asr;
    const std::int64_t found = db.for_each_row(
        "SELECT * FROM asr WHERE id = ?", [&](Row& row) { asr = asr_of(row); }, id);
    if (found == 0) {
      throw InputError(state_->file.string() + ": has no ASR " + std::to_string(id));
    }
    asr.exits = exits_of(db, id);
    if (detail == AsrDetail::geometry) return asr;
    asr.path = path_of(db, id);
    if (state_->reads_matched_path) take_matched_path(db, asr);
    if (detail == AsrDetail::readings) asr.readings = readings_of(db, state_->sensors, asr);
    return asr;
  });
}

std::vector<TruePose> GeoPackageStore::truth() const {
  return state_->reading([](Database& db) {
    std::vector<TruePose> poses;
    db.for_each_row(
        "SELECT timestamp_s, world_from_robot_x_m, world_from_robot_y_m, "
        "world_from_robot_theta_rad FROM truth ORDER BY id",
        [&](Row& row) {
          const double timestamp_s = row.real();
          poses.push_back({timestamp_s, row.pose()});
        });
    return poses;
  });
}

}  // namespace roomatlas
