// SPDX-License-Identifier: GPL-3.0-or-later
#include "geopackage_store_state.hpp"
#include "readings_codec.hpp"
#include "stored_names.hpp"
#include "wkb.hpp"

namespace roomatlas {
namespace {

constexpr AsrId kLargestAsrId = 0x7fffffff;  // so that asr * 2^32 + seq fits a key

/// One digit an edge, 1 where a line fit supports it; walls are parted by '|'.
std::string edges_text(const std::vector<WallPolyline>& walls) {
  std::string text;
  for (const WallPolyline& wall : walls) {
    if (&wall != &walls.front()) text += '|';
    for (const bool fitted : wall.edge_is_fitted) text += fitted ? '1' : '0';
  }
  return text;
}

Bytes walls_wkb(const std::vector<WallPolyline>& walls) {
  std::vector<Polyline> lines;
  for (const WallPolyline& wall : walls) lines.push_back(wall.vertices_asr);
  return wkb_of_lines(lines);
}

void insert_asr(Database& db, const Asr& asr) {
  const AsrCounters& n = asr.counters;
  db.run("INSERT INTO asr VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
         asr.id, asr.room, asr.start_s, asr.end_s, asr.odom_from_asr, asr.reference_point_asr,
         wkb_of_polygon(asr.outline_asr), walls_wkb(asr.walls), edges_text(asr.walls), n.grid_cells,
         n.grid_bytes, n.occupied_cells, n.cleaned_cells, n.extracted_points, n.vertices,
         n.geometry_bytes, n.ignored_ranges, asr.is_localized);
}

void insert_exits(Database& db, const Asr& asr) {
  std::int64_t key = row_keys(asr.id).first;
  for (const Exit& exit : asr.exits) {
    db.run("INSERT INTO exits VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", key++, asr.id,
           stored_name(kPassageKinds, exit.kind), exit.is_entry, exit.frame_from_pivot,
           exit.width_m, exit.jambs.a, exit.jambs.b, exit.neighbor, exit.timestamp_s);
  }
}

void insert_path(Database& db, const Asr& asr) {
  const std::int64_t first = row_keys(asr.id).first;
  std::int64_t seq = 0;
  for (const PathSample& sample : asr.path) {
    db.run("INSERT INTO path_samples VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", first + seq, asr.id,
           seq, sample.timestamp_s, sample.asr_from_robot, sample.odom_from_robot);
    ++seq;
  }
}

void insert_readings(Database& db, SensorTable& sensors, const Asr& asr) {
  if (asr.readings.empty()) return;
  const PackedReadings packed = pack_readings(
      asr, [&](const std::shared_ptr<const RangeSensor>& s) { return sensors.id_of(db, s); });
  db.run("INSERT INTO readings VALUES (?, ?, ?, ?)", asr.id, packed.count, packed.raw_bytes,
         packed.deflated);
}

}  // namespace

void delete_asr(Database& db, AsrId id) {
  const RowKeys keys = row_keys(id);
  db.run("DELETE FROM exits WHERE id BETWEEN ? AND ?", keys.first, keys.last);
  db.run("DELETE FROM path_samples WHERE id BETWEEN ? AND ?", keys.first, keys.last);
  db.run("DELETE FROM readings WHERE asr = ?", id);
  db.run("DELETE FROM asr WHERE id = ?", id);
}

void GeoPackageStore::State::write_pending_truth(Database& db) {
  for (const TruePose& truth : pending_truth) {
    db.run("INSERT INTO truth VALUES (NULL, ?, ?, ?, ?)", truth.timestamp_s,
           truth.world_from_robot);
  }
}

void GeoPackageStore::State::write_asr(Database& db, const Asr& asr) {
  insert_asr(db, asr);
  insert_exits(db, asr);
  insert_path(db, asr);
  insert_readings(db, sensors, asr);
}

void GeoPackageStore::State::replace_asrs(Database& db, const std::vector<Asr>& asrs) {
  for (const char* table : {"exits", "path_samples", "readings", "asr"}) {
    db.execute("DELETE FROM " + std::string(table));
  }
  for (const Asr& asr : asrs) write_asr(db, asr);
}

void GeoPackageStore::State::replace_asr(Database& db, const Asr& asr) {
  if (asr.id < 1 || asr.id > kLargestAsrId) throw std::invalid_argument("ASR ids start at 1");
  delete_asr(db, asr.id);
  write_asr(db, asr);
}

void GeoPackageStore::put(const Asr& asr) {
  state_->transaction([&](Database& db) {
    state_->replace_asr(db, asr);
    state_->write_pending_truth(db);
  });
  state_->pending_truth.clear();
}

void GeoPackageStore::put(const TruePose& truth) {
  state_->writing([&](Database&) { state_->pending_truth.push_back(truth); });
}

}  // namespace roomatlas
