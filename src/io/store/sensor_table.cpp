// SPDX-License-Identifier: GPL-3.0-or-later
#include "sensor_table.hpp"

#include "stored_names.hpp"

namespace roomatlas {
namespace {

Bytes beam_bytes(const RangeSensor& sensor) {
  ByteWriter out;
  out.u32(static_cast<std::uint32_t>(sensor.robot_from_beam.size()));
  for (const Pose2& beam : sensor.robot_from_beam) {
    for (const double value : {beam.x_m, beam.y_m, beam.theta_rad}) out.f64(value);
  }
  return out.take();
}

std::vector<Pose2> beams_of(ByteView bytes) {
  ByteReader in(bytes);
  std::vector<Pose2> beams(in.counted(in.u32(), 24));
  for (Pose2& beam : beams) {
    for (double* value : {&beam.x_m, &beam.y_m, &beam.theta_rad}) *value = in.f64();
  }
  return beams;
}

}  // namespace

std::int64_t SensorTable::id_of(Database& database,
                                const std::shared_ptr<const RangeSensor>& sensor) {
  const auto known = id_of_.find(sensor);
  if (known != id_of_.end()) return known->second;
  const char* kind = stored_name(kSensorKinds, sensor->kind);
  const Bytes beams = beam_bytes(*sensor);
  std::int64_t id = 0;
  database.for_each_row(
      "SELECT id FROM sensors WHERE kind = ? AND half_cone_rad IS ? AND max_range_m IS ? AND "
      "robot_from_beam = ?",
      [&](Row& row) { id = row.integer(); }, kind, sensor->half_cone_rad, sensor->max_range_m,
      beams);
  if (id == 0) {
    database.run("INSERT INTO sensors VALUES (NULL, ?, ?, ?, ?, ?)", kind, sensor->half_cone_rad,
                 sensor->max_range_m, static_cast<std::int64_t>(sensor->robot_from_beam.size()),
                 beams);
    id = database.last_inserted_id();
  }
  id_of_[sensor] = id;
  return id;
}

std::shared_ptr<const RangeSensor> SensorTable::get(Database& database, std::int64_t id) {
  const auto known = sensor_of_.find(id);
  if (known != sensor_of_.end()) return known->second;
  std::shared_ptr<const RangeSensor> found;
  database.for_each_row(
      "SELECT kind, half_cone_rad, max_range_m, robot_from_beam FROM sensors WHERE id = ?",
      [&](Row& row) {
        RangeSensor sensor;
        sensor.kind = value_of_stored_name(kSensorKinds, row.text());
        sensor.half_cone_rad = row.real();
        sensor.max_range_m = row.real();
        sensor.robot_from_beam = beams_of(row.blob());
        found = std::make_shared<const RangeSensor>(std::move(sensor));
      },
      id);
  if (!found)
    throw DamagedData("readings name sensor " + std::to_string(id) + ", which is missing");
  sensor_of_[id] = found;
  return found;
}

void SensorTable::forget() {
  id_of_.clear();
  sensor_of_.clear();
}

}  // namespace roomatlas
