// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/imdf.hpp"

#include <gmock/gmock.h>

#include <bitset>

#include "draw/flat_fixture.hpp"
#include "imdf_rules.hpp"
#include "roomatlas/io/plans/feature_ids.hpp"
#include "roomatlas/plan/door_keys.hpp"
#include "support/shipped_world.hpp"

namespace roomatlas {
namespace {

using test::broken_imdf_rules;
using test::imdf_features;
using test::imdf_files;
using test::ImdfFiles;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const ImdfOptions kOptions{"6f1e", {48.013, 7.8335, 30.0}, {"Am Ring 5", "Freiburg", "DE", ""}, ""};

/// Of each feature of a type, by name where it has one, else by its place in the file.
std::map<std::string, std::string> ids_of(const ImdfFiles& files, const std::string& type) {
  std::map<std::string, std::string> ids;
  for (const nlohmann::json& feature : imdf_features(files, type)) {
    ids[feature["geometry"].dump()] = feature["id"];
  }
  return ids;
}

TEST(Imdf, OfEachWorldKeepsTheRulesOfTheSpecification) {
  for (const char* name : {"two_rooms", "eight_rooms", "nine_rooms", "identical_rooms", "open_hall",
                           "afit_floor", "slanted_and_curved"}) {
    const FloorPlan plan = test::shipped_world(name);
    const ImdfFiles files = imdf_files(imdf_archive(plan, kOptions));
    EXPECT_THAT(broken_imdf_rules(files), IsEmpty()) << name;
    EXPECT_GE(imdf_features(files, "unit").size(), plan.rooms.size()) << name;
  }
}

TEST(Imdf, OfADraftedFlatKeepsThemInAnyFrame) {
  for (const double turn_deg : {0.0, 12.0, 77.0}) {
    const FloorPlan plan = test::moved(test::flat(), {3.0, -20.0, radians(turn_deg)});
    const ImdfFiles files = imdf_files(imdf_archive(plan, kOptions));
    EXPECT_THAT(broken_imdf_rules(files), IsEmpty()) << turn_deg;
    EXPECT_THAT(imdf_features(files, "opening"), SizeIs(3));       // a window is none
    EXPECT_THAT(imdf_features(files, "unit"), SizeIs(3 + 1 + 1));  // rooms, a wall, a window
    EXPECT_THAT(imdf_features(files, "fixture"), SizeIs(2));
    EXPECT_THAT(imdf_features(files, "relationship"), SizeIs(1));
  }
}

// The rules are worth something only where they notice.
TEST(ImdfRules, NoticeWhatIsBroken) {
  const ImdfFiles good = imdf_files(imdf_archive(test::flat(), kOptions));
  const auto breaks = [&](const std::function<void(ImdfFiles&)>& change) {
    ImdfFiles files = good;
    change(files);
    return broken_imdf_rules(files).size();
  };
  const auto first = [](ImdfFiles& files, const std::string& type) -> nlohmann::json& {
    return files[type + ".geojson"]["features"][0];
  };
  EXPECT_EQ(breaks([](ImdfFiles&) {}), 0U);
  EXPECT_GT(breaks([](ImdfFiles& f) { f.erase("level.geojson"); }), 0U);
  EXPECT_GT(breaks([](ImdfFiles& f) { f["manifest.json"].erase("language"); }), 0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) { first(f, "unit")["properties"]["category"] = "den"; }), 0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) { first(f, "unit")["properties"].erase("alt_name"); }), 0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) { first(f, "unit")["id"] = first(f, "level")["id"]; }), 0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) {
              first(f, "unit")["properties"]["level_id"] = first(f, "unit")["id"];
            }),
            0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) {
              auto& end = first(f, "opening")["geometry"]["coordinates"][0][0];
              end = end.get<double>() + 3e-7;  // 2 cm
            }),
            0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) {
              auto& corner = first(f, "unit")["geometry"]["coordinates"][0][1][1];
              corner = corner.get<double>() - 1e-4;  // 10 m
            }),
            0U);
  EXPECT_GT(breaks([&](ImdfFiles& f) {
              first(f, "relationship")["properties"]["destination"]["id"] = first(f, "venue")["id"];
            }),
            0U);
}

TEST(Imdf, ARoomKeepsItsIdentifierWhenItIsRenamedAndOthersCome) {
  FloorPlan plan = test::flat();
  const auto before = ids_of(imdf_files(imdf_archive(plan, kOptions)), "unit");
  for (PlanRoom& room : plan.rooms) room.name = "Suite " + room.name;
  plan.rooms.insert(plan.rooms.begin(),
                    test::room(9, "Annex", RoomKind::room, {{20.0, 0.0}, {24.0, 3.0}}));
  std::reverse(plan.doors.begin(), plan.doors.end());
  ImdfOptions later = kOptions;
  later.date = "2031-05-06";
  const ImdfFiles files = imdf_files(imdf_archive(plan, later));
  const auto after = ids_of(files, "unit");
  EXPECT_EQ(after.size(), before.size() + 1);
  for (const auto& [shape, id] : before) EXPECT_EQ(after.at(shape), id);
  EXPECT_EQ(files.at("manifest.json")["created"], "2031-05-06T00:00:00Z");
}

TEST(Imdf, AnotherBuildingHasNoIdentifierInCommon) {
  ImdfOptions other = kOptions;
  other.building = "77aa";
  const auto ours = ids_of(imdf_files(imdf_archive(test::flat(), kOptions)), "unit");
  const auto theirs = ids_of(imdf_files(imdf_archive(test::flat(), other)), "unit");
  for (const auto& [shape, id] : ours) EXPECT_NE(theirs.at(shape), id);
}

TEST(Imdf, TheSamePlanGivesTheSameBytes) {
  EXPECT_EQ(imdf_archive(test::flat(), kOptions), imdf_archive(test::flat(), kOptions));
}

TEST(Imdf, ACategoryIsThatOfAWordOfTheNameElseOfTheKind) {
  const auto category = [](const std::string& name, RoomKind kind) {
    return imdf_category(test::room(1, name, kind, {{0, 0}, {1, 1}}));
  };
  EXPECT_EQ(category("7", RoomKind::room), "room");
  EXPECT_EQ(category("7", RoomKind::hall), "room");
  EXPECT_EQ(category("7", RoomKind::corridor), "walkway");
  EXPECT_EQ(category("Meeting room 3", RoomKind::room), "conferenceroom");
  EXPECT_EQ(category("WC (2)", RoomKind::room), "restroom");
  EXPECT_EQ(category("Labyrinth", RoomKind::room), "room");  // no word of the list
}

TEST(FeatureIds, AreOfVersionFourAndTheSame128BitsForIfc) {
  const Uuid id = FeatureIds("6f1e").of("room/7");
  EXPECT_THAT(id.text(),
              ::testing::MatchesRegex(
                  "[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}"));
  // Read back by buildingSMART's alphabet, most significant digit first.
  const std::string alphabet = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  const std::string text = id.ifc();
  ASSERT_EQ(text.size(), 22U);
  std::string bits;
  for (const char c : text) {
    ASSERT_NE(alphabet.find(c), std::string::npos);
    bits += std::bitset<6>(alphabet.find(c)).to_string();
  }
  std::string true_bits = "0000";  // 22 letters hold four more than 128
  for (const std::uint8_t byte : id.bytes) true_bits += std::bitset<8>(byte).to_string();
  EXPECT_EQ(bits, true_bits);
}

TEST(DoorKeys, NameTheRoomsAndCountDoorsBetweenTheSame) {
  FloorPlan plan;
  const auto door = [](std::int64_t id, double x, std::optional<RoomId> a,
                       std::optional<RoomId> b) {
    PlanDoor made;
    made.id = id;
    made.jambs = {{x, 0.0}, {x + 0.9, 0.0}};
    made.room_a = a;
    made.room_b = b;
    return made;
  };
  plan.doors = {door(1, 5.0, 3, 4), door(2, 1.0, 3, 4), door(3, 0.0, 3, std::nullopt),
                door(4, 9.0, std::nullopt, std::nullopt)};
  EXPECT_THAT(door_keys(plan), ElementsAre("3-4-2", "3-4", "3-out", "out-out"));
}

}  // namespace
}  // namespace roomatlas
