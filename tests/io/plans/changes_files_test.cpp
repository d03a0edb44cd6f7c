// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/changes_files.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace roomatlas {
namespace {

using Json = nlohmann::json;

PlanChanges changes() {
  Change moved;
  moved.id = 1;
  moved.kind = ChangeKind::furniture_moved;
  moved.gone = {{{{0, 0}, {1, 0}, {1, 1}}, {}}};
  moved.appeared = {{{{2, 0}, {3, 0}, {3, 1}}, {}}};
  moved.at = {2.5, 0.25};
  moved.room = 4;
  moved.room_name = "Lab, west";
  moved.size_m = 1.4142;
  moved.before = {12, 34, {1, 3}, 100.5, 120.0};
  moved.after = {56, 7, {2}, 200.0, 201.25};
  PlanChanges found;
  found.old_from_new = {1.0, -2.0, kPi / 2.0};
  found.changes = {moved};
  found.rooms = {{9, "Attic", true, 12.0, 0.25}, {3, "Shed", false, 8.0, 0.0}};
  found.not_seen_again = {{{{5, 5}, {7, 5}, {7, 6}, {5, 6}}, {}}};
  return found;
}

TEST(ChangesCsv, HasALineForEachChangeAndEachRoom) {
  EXPECT_EQ(changes_csv(changes()),
            "id,kind,room,room_name,door,x_m,y_m,size_m,before_stood,before_passed,before_visits,"
            "before_first_s,before_last_s,after_stood,after_passed,after_visits,after_first_s,"
            "after_last_s\r\n"
            "1,furniture moved,4,\"Lab, west\",,2.5,0.25,1.414,12,34,1 3,100.5,120,56,7,2,200,"
            "201.25\r\n"
            ",room not visited again,9,Attic,,,,,,,,,,,,,,\r\n"
            ",room first visited,3,Shed,,,,,,,,,,,,,,\r\n");
}

TEST(ChangesGeojson, HasBothHalvesOfWhatWasMovedAndWhatWasNotSeen) {
  const Json json = Json::parse(changes_geojson(changes()));
  EXPECT_EQ(json["roomatlas"]["schema"], "changes");
  EXPECT_EQ(json["roomatlas"]["old_from_new"], Json({1.0, -2.0, 90.0}));
  ASSERT_EQ(json["features"].size(), 3U);
  EXPECT_EQ(json["features"][0]["properties"]["state"], "gone");
  EXPECT_EQ(json["features"][1]["properties"]["state"], "new");
  EXPECT_EQ(json["features"][1]["properties"]["after"]["stood_readings"], 56);
  EXPECT_EQ(json["features"][1]["properties"]["id"], 1);
  EXPECT_EQ(json["features"][2]["properties"]["kind"], "not seen again");
}

TEST(ChangesJson, SaysHowMuchWasNotSeenAgain) {
  const Json json = Json::parse(changes_json(changes()));
  EXPECT_EQ(json["not_seen_again_m2"], 2.0);
  EXPECT_EQ(json["changes"][0]["before"]["visits"], Json({1, 3}));
  EXPECT_EQ(json["rooms"][0]["kind"], "room not visited again");
  EXPECT_EQ(json["rooms"][1]["kind"], "room first visited");
}

}  // namespace
}  // namespace roomatlas
