// SPDX-License-Identifier: GPL-3.0-or-later
// The files that `export` writes, as other programs see them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class Exports : public ::testing::Test {
 protected:
  void SetUp() override {
    store_ = assembled_store(folder_);
    ASSERT_EQ(run("-q rename " + store_ + " 3 'Lab <3> & Kitchen'").exit_code, 0);
  }
  /// @returns the folder, with a slash
  std::string exported(const std::string& options) {
    const std::string out = (folder_ / "out").string();
    const Outcome outcome = run("-q export " + store_ + " " + options + " -o " + out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return out + "/";
  }
  [[nodiscard]] Json rooms(const std::string& out) const {
    Json found = Json::array();
    for (const Json& feature : Json::parse(content_of(out + "plan.local.geojson"))["features"]) {
      if (feature["properties"].contains("area_m2")) found.push_back(feature["properties"]);
    }
    return found;
  }

  Folder folder_;
  std::string store_;
};

TEST_F(Exports, AllTogetherHoldTheFilesThatBuildWrites) {
  const std::string out = exported("");
  for (const char* name :
       {"plan.svg", "plan.pdf", "plan.png", "plan.local.geojson", "rooms.graphml", "rooms.dot",
        "graph.g2o", "trajectory_odometry.tum", "trajectory_corrected.tum", "map.pgm", "map.yaml",
        "keepout_mask.pgm", "keepout_mask.yaml", "rooms.yaml", "rooms.csv", "summary.json"}) {
    EXPECT_GT(content_of(out + name).size(), 0U) << name;
  }
}

TEST_F(Exports, EveryRoomsNameIsTextInThePdf) {
  ROOMATLAS_NEEDS("pdftotext");
  const std::string out = exported("-f pdf,geojson --draw-graph --draw-path");
  const Outcome text = run_other("pdftotext -layout " + out + "plan.pdf -");
  ASSERT_EQ(text.exit_code, 0) << text.err;
  std::istringstream stream(text.out);
  const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  for (const Json& room : rooms(out)) {
    const std::string name = room["name"];
    if (name.find(' ') == std::string::npos) EXPECT_THAT(words, ::testing::Contains(name));
  }
  EXPECT_THAT(text.out, HasSubstr("Lab <3>"));
}

TEST_F(Exports, GraphsAreAcceptedAndHaveEveryRoom) {
  ROOMATLAS_NEEDS("xmllint");
  ROOMATLAS_NEEDS("dot");
  const std::string out = exported("-f graphml,geojson,svg,dot");
  EXPECT_EQ(run_other("dot -Tsvg " + out + "rooms.dot").exit_code, 0);
  EXPECT_EQ(run_other("xmllint --noout " + out + "rooms.graphml " + out + "plan.svg").exit_code, 0);
  const Outcome count =
      run_other("xmllint --xpath 'count(//*[local-name()=\"node\"])' " + out + "rooms.graphml");
  EXPECT_EQ(std::stoul(count.out), rooms(out).size());
}

TEST_F(Exports, ThePoseGraphIsReadByTheSolverAndIsNearItsBest) {
  const std::string out = exported("-f g2o");
  const Outcome solved =
      run("--json optimize " + out + "graph.g2o -o " + (folder_ / "solved.g2o").string());
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const Json report = Json::parse(solved.out);
  EXPECT_GT(report["loops"].get<int>() + report["edges"].get<int>(), 0);
  EXPECT_TRUE(report["converged"]);
}

TEST_F(Exports, WithAPlaceOnEarthThereIsGeoJsonOfIt) {
  const std::string out = exported("-f geojson --georef 48.0130,7.8335,30");
  const Json plan = Json::parse(content_of(out + "plan.geojson"));
  EXPECT_EQ(plan["type"], "FeatureCollection");
  const Json& first = plan["features"][0];
  EXPECT_TRUE(first["properties"].contains("indoor"));
  EXPECT_NEAR(first["geometry"]["coordinates"][0][0][0].get<double>(), 7.8335, 0.01);
  EXPECT_NEAR(first["geometry"]["coordinates"][0][0][1].get<double>(), 48.0130, 0.01);
}

TEST_F(Exports, APlaceThatIsNotOnEarthIsAUsageError) {
  const Outcome outcome =
      run("-q export " + store_ + " -f geojson --georef 148,7,0 -o " + (folder_ / "out").string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--georef"));
}

TEST_F(Exports, TheStoreTellsQgisHowToDrawItsLayers) {
  ROOMATLAS_NEEDS("ogrinfo");
  const Outcome styles = run_other(
      "ogrinfo -q " + store_ +
      " -sql \"SELECT f_table_name, useAsDefault FROM layer_styles ORDER BY f_table_name\"");
  for (const char* layer : {"doors", "free_space", "furniture", "path", "rooms", "walls"}) {
    EXPECT_THAT(styles.out, HasSubstr(std::string(" = ") + layer + "\n"));
  }
  EXPECT_THAT(styles.out + styles.err, Not(HasSubstr("ERROR")));
}

}  // namespace
}  // namespace roomatlas::test
