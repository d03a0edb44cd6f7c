// SPDX-License-Identifier: GPL-3.0-or-later
// Several missions of one building between which a door was shut, a table moved and a wall built,
// as a user joins them. What is drawn is held against the world as it was in the end.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "random_store.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDay_s = 86400.0;

Json rectangle(const std::string& kind, double x_m, double y_m, double length_m, double width_m) {
  const Json ring = {{x_m, y_m},
                     {x_m + length_m, y_m},
                     {x_m + length_m, y_m + width_m},
                     {x_m, y_m + width_m},
                     {x_m, y_m}};
  return {{"type", "Feature"},
          {"properties", {{"kind", kind}}},
          {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}};
}

const Json kTableBefore = rectangle("furniture", 20.6, 10.2, 1.2, 2.2);
const Json kTableAfter = rectangle("furniture", 19.6, 13.0, 1.2, 2.2);
const Json kWall = rectangle("wall", 0.1, 3.9, 2.1, 0.15);
constexpr int kDoor = 2;  // of the store
const Point2 kDoorMiddle(5.3, 7.4);
const Box2 kLounge{{18.9, 7.1}, {23.5, 15.5}};  // without what stands at its rim

Json corner_of(const Json& feature) { return feature["geometry"]["coordinates"][0][0]; }

Polygon outline_of(const Json& feature) {
  Polygon polygon;
  for (const Json& point : feature["geometry"]["coordinates"][0]) {
    polygon.outer.emplace_back(point[0], point[1]);
  }
  polygon.outer.pop_back();
  return polygon;
}

/// The log as if it had been driven later.
void write_later(const std::string& log, const std::string& out, double later_s) {
  std::ifstream lines(log);
  std::ofstream file(out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("FLASER") && !line.starts_with("ODOM") && !line.starts_with("TRUEPOS")) {
      file << line << '\n';
      continue;
    }
    std::istringstream words(line);
    std::vector<std::string> all{std::istream_iterator<std::string>(words), {}};
    for (const std::size_t from_end : {1U, 3U}) {
      std::string& time = all[all.size() - from_end];
      time = std::to_string(std::stod(time) + later_s);
    }
    for (const std::string& word : all) file << word << ' ';
    file << '\n';
  }
}

class LatestStateOfABuilding : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string before = world("before", false);
    const std::string after = world("after", true);
    a_ = mission("a", before, 1, 0.0);
    b_ = mission("b", after, 3, 2.0 * kDay_s);
    same_ = mission("same", before, 2, 2.0 * kDay_s + 5.0);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string path(const std::string& name) { return (*folder_ / name).string(); }

  /// The eight rooms as they are, or altered.
  static std::string world(const std::string& name, bool is_altered) {
    Json rooms = Json::parse(
        content_of(std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/eight_rooms.geojson"));
    if (is_altered) {
      for (Json& feature : rooms["features"]) {
        Json& properties = feature["properties"];
        const bool is_door = properties["kind"] == "door" && properties["id"] == kDoor;
        if (is_door) properties["leaf"] = properties["jambs"];
        if (corner_of(feature) == corner_of(kTableBefore)) feature = kTableAfter;
      }
      rooms["features"].push_back(kWall);
    }
    std::ofstream(path(name + ".geojson")) << rooms;
    return path(name + ".geojson");
  }

  /// @returns an assembled store of one mission
  static std::string mission(const std::string& name, const std::string& world, int seed,
                             double later_s) {
    const Outcome made = run("-q simulate " + world + " --sensor laser --tour --speed 0.7 --seed " +
                             std::to_string(seed) + " -o " + path(name));
    EXPECT_EQ(made.exit_code, 0) << made.err;
    write_later(path(name) + "/mission.clf", path(name + ".clf"), later_s);
    const std::string store = path(name + ".gpkg");
    EXPECT_EQ(run("-q map " + path(name + ".clf") + " -o " + store).exit_code, 0);
    EXPECT_EQ(run("-q assemble " + store).exit_code, 0);
    return store;
  }

  static Outcome joined(const std::string& stores, const std::string& out) {
    return run("join " + stores + " -o " + path(out));
  }
  /// `latest.gpkg`, joined once of the mission before and the one after.
  static const Outcome& latest() {
    static const Outcome done = joined(a_ + " " + b_, "latest.gpkg");
    return done;
  }

  /// The plan as a file, of a store or of what it becomes when it is assembled again.
  static std::string plan_file(const std::string& store) {
    const Outcome done = run("-q export " + store + " -f geojson,json -o " + path("out"));
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return content_of(path("out") + "/plan.local.geojson");
  }

  static FloorPlan plan_of(const std::string& store) {
    return GeoPackageStore(store, GeoPackageStore::Mode::read).plan();
  }

  /// By the first pose of its first mission.
  static Pose2 world_from_building(const std::string& file) {
    const GeoPackageStore store(file, GeoPackageStore::Mode::read);
    const Asr first = store.get(store.ids().front(), AsrDetail::path);
    const Pose2 building_from_asr = placement_of(store.correction()).at(first.id);
    return store.truth().front().world_from_robot *
           inverse(building_from_asr * first.path.front().asr_from_robot);
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string a_;
  static inline std::string b_;
  static inline std::string same_;  ///< of the building before, driven when b_ was
};

/// Of some outlines and a true one the shared area over that of both, counted by points.
double iou(const std::vector<PlanFurniture>& drawn, const Pose2& world_from_building,
           const Polygon& truth, const Box2& around) {
  int both = 0;
  int either = 0;
  for (double x_m = around.min.x(); x_m < around.max.x(); x_m += 0.02) {
    for (double y_m = around.min.y(); y_m < around.max.y(); y_m += 0.02) {
      const Point2 at(x_m, y_m);
      const Point2 in_building = inverse(world_from_building) * at;
      const bool is_drawn = std::any_of(drawn.begin(), drawn.end(), [&](const PlanFurniture& one) {
        return contains(one.outline, in_building);
      });
      const bool is_true = contains(truth, at);
      both += is_drawn && is_true ? 1 : 0;
      either += is_drawn || is_true ? 1 : 0;
    }
  }
  return static_cast<double>(both) / either;
}

/// The share of the wall that was built where the plan has something, wall or furniture.
double built_share(const FloorPlan& plan, const Pose2& world_from_building) {
  int drawn = 0;
  int all = 0;
  for (double x_m = 0.4; x_m < 2.1; x_m += 0.05) {
    const Point2 at = inverse(world_from_building) * Point2(x_m, 3.975);
    const auto holds = [&](const Polygon& body) { return contains(body, at); };
    const std::vector<Polygon> furniture = outlines_of(plan.furniture);
    const bool is_drawn = std::any_of(plan.walls.begin(), plan.walls.end(), holds) ||
                          std::any_of(furniture.begin(), furniture.end(), holds);
    drawn += is_drawn ? 1 : 0;
    ++all;
  }
  return static_cast<double>(drawn) / all;
}

const PlanDoor* door_near(const FloorPlan& plan, const Point2& at) {
  const auto found = std::find_if(plan.doors.begin(), plan.doors.end(), [&](const PlanDoor& door) {
    return ((door.jambs.a + door.jambs.b) / 2.0 - at).norm() < 0.3;
  });
  return found == plan.doors.end() ? nullptr : &*found;
}

TEST_F(LatestStateOfABuilding, IsDrawnAsItIsByNow) {
  ASSERT_EQ(latest().exit_code, 0) << latest().err;
  EXPECT_THAT(latest().err,
              HasSubstr("3 things are drawn as b.clf saw them last (1 door shut, 1 piece "
                        "of furniture moved, 1 wall new)"));
  const FloorPlan drawn = plan_of(path("latest.gpkg"));
  const Pose2 frame = world_from_building(path("latest.gpkg"));
  std::filesystem::copy_file(path("latest.gpkg"), path("sum.gpkg"));
  ASSERT_EQ(run("-q assemble " + path("sum.gpkg") + " --no-draw-latest").exit_code, 0);
  const FloorPlan sum = plan_of(path("sum.gpkg"));

  const Polygon table = outline_of(kTableAfter);
  EXPECT_GT(iou(drawn.furniture, frame, table, kLounge), 0.8);
  EXPECT_LT(iou(sum.furniture, frame, table, kLounge), 0.5);
  EXPECT_GT(built_share(drawn, frame), 0.8);
  EXPECT_LT(built_share(sum, frame), 0.5);

  const Point2 in_store = inverse(frame) * Point2(2.7, 7.0);  // shut by now, and seen before
  EXPECT_TRUE(std::any_of(drawn.rooms.begin(), drawn.rooms.end(), [&](const PlanRoom& room) {
    return contains(room.parts.front(), in_store) && std::abs(room.area_m2 - 20.0) < 0.5;
  }));
  const PlanDoor* const door = door_near(drawn, inverse(frame) * kDoorMiddle);
  ASSERT_NE(door, nullptr);
  ASSERT_TRUE(door->leaf.has_value());
  EXPECT_LT((door->leaf->a - door->jambs.a).norm() + (door->leaf->b - door->jambs.b).norm(), 0.01);
  for (const PlanDoor& other : drawn.doors) EXPECT_TRUE(&other == door || !other.leaf);
}

TEST_F(LatestStateOfABuilding, IsInTheSummaryAndInTheStore) {
  ASSERT_EQ(joined(b_ + " " + a_ + " --jobs 3", "told.gpkg").exit_code, 0);
  const std::string plan = plan_file(path("told.gpkg"));
  const Json seen = Json::parse(content_of(path("out") + "/summary.json")).at("seen_last");
  ASSERT_EQ(seen["missions"].size(), 1U);
  EXPECT_EQ(seen["missions"][0]["mission"], "b.clf");
  ASSERT_EQ(seen["missions"][0]["things"].size(), 3U);
  const Point2 door = inverse(world_from_building(path("told.gpkg"))) * kDoorMiddle;
  const Json& shut = seen["missions"][0]["things"][0];
  EXPECT_EQ(shut["kind"], "door shut");
  EXPECT_LT((Point2(shut["at"][0], shut["at"][1]) - door).norm(), 0.15);

  // Assembled again, by however many threads, it is the same; of one mission it is what that saw.
  ASSERT_EQ(run("-q assemble " + path("told.gpkg") + " --jobs 1").exit_code, 0);
  EXPECT_EQ(plan_file(path("told.gpkg")), plan);
  ASSERT_EQ(run("-q assemble " + path("told.gpkg") + " --missions a").exit_code, 0);
  (void)plan_file(path("told.gpkg"));
  EXPECT_FALSE(Json::parse(content_of(path("out") + "/summary.json")).contains("seen_last"));
  EXPECT_GT(iou(plan_of(path("told.gpkg")).furniture, world_from_building(path("told.gpkg")),
                outline_of(kTableBefore), kLounge),
            0.8);
}

TEST_F(LatestStateOfABuilding, IsOnTheReportPageWhereAClickShowsIt) {
  ROOMATLAS_NEEDS("chromium");
  ROOMATLAS_NEEDS("node");
  ASSERT_EQ(latest().exit_code, 0);
  const std::string page = path("page.html");
  ASSERT_EQ(run("-q report " + path("latest.gpkg") + " -o " + page).exit_code, 0);
  const Outcome looked =
      run_other("timeout 300 node " + std::string(ROOMATLAS_SOURCE_DIR) +
                "/tests/apps/browser/changed.mjs " + page + " " + path("profile"));
  EXPECT_EQ(looked.exit_code, 0) << looked.err;
  EXPECT_EQ(looked.out, "rows 3; 1 ring, there; 1 ring, there; complaints ");
}

TEST_F(LatestStateOfABuilding, WithoutChangesIsTheSumToTheByte) {
  const Outcome done = joined(a_ + " " + same_, "unchanged.gpkg");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, Not(HasSubstr("saw")));
  const std::string plan = plan_file(path("unchanged.gpkg"));
  ASSERT_EQ(run("-q assemble " + path("unchanged.gpkg") + " --no-draw-latest").exit_code, 0);
  EXPECT_EQ(plan_file(path("unchanged.gpkg")), plan);
}

TEST_F(LatestStateOfABuilding, OfMissionsAtOneTimeNoneIsTheLatest) {
  const Outcome done = joined(same_ + " " + b_, "at_once.gpkg");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.err, Not(HasSubstr("saw")));
}

}  // namespace
}  // namespace roomatlas::test
