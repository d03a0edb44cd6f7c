// SPDX-License-Identifier: GPL-3.0-or-later
#include "member_missions.hpp"

#include <optional>

#include "geopackage_schema.hpp"
#include "stored_names.hpp"

namespace roomatlas {
namespace {

constexpr const char* kTable = "missions";

void create_table(Database& db) {
  db.execute(
      "CREATE TABLE missions (id INTEGER PRIMARY KEY, name TEXT NOT NULL, sensor TEXT NOT NULL, "
      "first_asr INTEGER NOT NULL, last_asr INTEGER NOT NULL, is_base INTEGER NOT NULL, "
      "score REAL, runner_up_score REAL, agreement REAL, pieces INTEGER, pieces_fitting INTEGER, "
      "true_poses INTEGER NOT NULL)");
  db.run(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change) "
      "VALUES (?, 'attributes', ?, 'Missions that the building was joined from', ?)",
      kTable, kTable, last_change_of(std::nullopt));
}

MemberMission member_of(Row& row) {
  MemberMission member;
  member.name = row.name();
  member.sensor = value_of_stored_name(kSensorKinds, row.text());
  member.first_asr = row.integer();
  member.last_asr = row.integer();
  member.is_base = row.flag();
  member.score = row.real();
  member.runner_up_score = row.real();
  member.agreement = row.real();
  member.pieces = static_cast<int>(row.integer());
  member.pieces_fitting = static_cast<int>(row.integer());
  member.true_poses = row.integer();
  return member;
}

}  // namespace

void write_members(Database& db, const std::vector<MemberMission>& members) {
  if (!db.connection().tableExists(kTable)) create_table(db);
  db.execute("DELETE FROM missions");
  for (const MemberMission& member : members) {
    db.run("INSERT INTO missions VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", member.name,
           stored_name(kSensorKinds, member.sensor), member.first_asr, member.last_asr,
           member.is_base, member.score, member.runner_up_score, member.agreement, member.pieces,
           member.pieces_fitting, member.true_poses);
  }
}

std::vector<MemberMission> read_members(Database& db) {
  std::vector<MemberMission> members;
  if (!db.connection().tableExists(kTable)) return members;
  db.for_each_row(
      "SELECT name, sensor, first_asr, last_asr, is_base, score, runner_up_score, agreement, "
      "pieces, pieces_fitting, true_poses FROM missions ORDER BY id",
      [&](Row& row) { members.push_back(member_of(row)); });
  return members;
}

}  // namespace roomatlas
