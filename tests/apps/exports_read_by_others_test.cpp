// SPDX-License-Identifier: GPL-3.0-or-later
// Each format that `export` writes as text, tables or pictures, read by libraries of Python that
// know nothing of Roomatlas; what they find must agree among the formats.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "exports.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"

namespace roomatlas::test {
namespace {

using ::testing::DoubleNear;
using ::testing::Pointwise;

const std::string kPython = "/usr/bin/python3";  // whose packages are the system's

class ReadByOthers : public Exports {
 protected:
  void SetUp() override {
    const Outcome found =
        run_other(kPython + " -c 'import networkx, numpy, shapely, yaml; import PIL'");
    if (found.exit_code != 0) {
      const char* ci = std::getenv("CI");
      if (ci != nullptr && std::string(ci) == "true") FAIL() << found.err;
      GTEST_SKIP() << found.err;
    }
    Exports::SetUp();
  }

  /// What the readers tell of an export.
  /// @param readers names of functions of read_exports.py, parted by spaces
  Json told(const std::string& formats, const std::string& readers) {
    out_ = exported("-f " + formats);
    const Outcome outcome = run_other(kPython + " " + ROOMATLAS_SOURCE_DIR +
                                      "/tests/apps/read_exports.py " + out_ + " " + readers);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? Json::parse(outcome.out) : Json::object();
  }

  std::string out_;
};

using Numbers = std::vector<double>;
using Strings = std::vector<std::string>;

TEST_F(ReadByOthers, RoomsAreTheSameInYamlAndCsvAndTheirOutlinesHaveTheirAreas) {
  const Json found = told("nav2,csv", "rooms_yaml rooms_csv");
  const Json yaml = found.at("rooms_yaml");
  const auto areas_m2 = yaml.at("areas_m2").get<Numbers>();
  ASSERT_GT(areas_m2.size(), 3U);
  EXPECT_THAT(yaml.at("outlines_m2").get<Numbers>(), Pointwise(DoubleNear(0.01), areas_m2));
  EXPECT_EQ(yaml.at("goals_inside"), areas_m2.size());
  EXPECT_THAT(found.at("rooms_csv").at("areas_m2").get<Numbers>(),
              Pointwise(DoubleNear(0.006), areas_m2));
  EXPECT_EQ(found.at("rooms_csv").at("names"), yaml.at("names"));
  EXPECT_THAT(yaml.at("names").get<Strings>(), ::testing::Contains("Lab <3> & Kitchen"));
}

TEST_F(ReadByOthers, TheMapsFreeCellsLieInTheRooms) {
  const Json found = told("nav2", "map_yaml rooms_yaml");
  double rooms_m2 = 0.0;
  for (const double area_m2 : found.at("rooms_yaml").at("areas_m2")) rooms_m2 += area_m2;
  const Json map = found.at("map_yaml");
  EXPECT_GT(map.at("inside"), 0.99);
  EXPECT_NEAR(map.at("free_m2").get<double>(), rooms_m2, 0.15 * rooms_m2);
  EXPECT_GT(map.at("occupied_m2"), 1.0);
}

TEST_F(ReadByOthers, OpenRmfsBuildingHasTheDoorsAndFloorsOfThePlan) {
  const Json found = told("rmf,nav2,geojson", "building_yaml rooms_yaml");
  const Json building = found.at("building_yaml");
  EXPECT_TRUE(building.at("references_hold"));
  const FloorPlan plan = read_plan(out_ + "plan.local.geojson");
  auto doors_m = building.at("doors_m").get<Numbers>();
  Numbers expected_m;
  for (const PlanDoor& door : plan.doors) {
    expected_m.push_back((door.jambs.b - door.jambs.a).norm());
  }
  std::sort(doors_m.begin(), doors_m.end());
  std::sort(expected_m.begin(), expected_m.end());
  EXPECT_THAT(doors_m, Pointwise(DoubleNear(0.01), expected_m));
  const auto floors_m2 = building.at("floors_m2").get<Numbers>();
  for (const double area_m2 : found.at("rooms_yaml").at("areas_m2")) {
    EXPECT_THAT(floors_m2, ::testing::Contains(DoubleNear(area_m2, 0.01)));
  }
  EXPECT_GT(building.at("lanes"), 0);
  EXPECT_THAT(building.at("names").get<Strings>(),
              ::testing::IsSupersetOf(found.at("rooms_yaml").at("names").get<Strings>()));
}

TEST_F(ReadByOthers, TheRouteGraphHangsTogetherAndItsEdgesRunFromNodeToNodeOverTheFloor) {
  const Json graph = told("nav2-route,nav2", "route_graph").at("route_graph");
  EXPECT_GT(graph.at("edges"), 10);
  EXPECT_TRUE(graph.at("all_have_places"));
  EXPECT_EQ(graph.at("parts"), 1);
  EXPECT_LT(graph.at("off_m"), 0.002);
  EXPECT_LT(graph.at("beyond_m").get<double>(), 1.0);  // door leaves' thickness
}

TEST_F(ReadByOthers, ChiSquareOfThePoseGraphByItsDefinitionIsWhatOptimizeBeginsWith) {
  const Json graph = told("g2o", "graph_g2o").at("graph_g2o");
  const Json solved = Json::parse(
      run("--json optimize " + out_ + "graph.g2o -o " + (folder_ / "solved.g2o").string()).out);
  EXPECT_EQ(graph.at("vertices"), solved.at("nodes"));
  EXPECT_EQ(graph.at("edges"), solved.at("edges"));
  const double chi2 = solved.at("initial_chi_square");
  EXPECT_GT(chi2, 0.1);
  EXPECT_NEAR(graph.at("chi2").get<double>(), chi2, 1e-6 * chi2);
}

TEST_F(ReadByOthers, TrajectoriesAreRowsOfTimePlaceAndUnitQuaternion) {
  const Json rows = told("tum", "trajectory").at("trajectory");
  EXPECT_GT(rows.at("poses"), 100);
  EXPECT_EQ(rows.at("columns"), 8);
  EXPECT_TRUE(rows.at("in_order"));
  EXPECT_LT(rows.at("unit_off"), 1e-9);
}

TEST_F(ReadByOthers, ThePngIsAPictureOfManyShades) {
  const Json picture = told("png", "pictures").at("pictures").at("plan.png");
  EXPECT_GT(picture.at("width"), 500);
  EXPECT_GT(picture.at("shades"), 50);
}

}  // namespace
}  // namespace roomatlas::test
