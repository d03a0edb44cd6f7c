// SPDX-License-Identifier: GPL-3.0-or-later
// The files that `export` writes, as other programs see them.
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "exports.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Exports, AllTogetherHoldTheFilesThatBuildWrites) {
  const std::string out = exported("");
  for (const char* name : {"plan.svg",
                           "plan.pdf",
                           "plan.png",
                           "plan.local.geojson",
                           "rooms.graphml",
                           "rooms.dot",
                           "graph.g2o",
                           "trajectory_odometry.tum",
                           "trajectory_corrected.tum",
                           "map.pgm",
                           "map.yaml",
                           "keepout_mask.pgm",
                           "keepout_mask.yaml",
                           "rooms.yaml",
                           "rooms.csv",
                           "summary.json",
                           "route_graph.geojson",
                           "building.yaml",
                           "plan.imdf.zip",
                           "plan.ifc"}) {
    EXPECT_GT(content_of(out + name).size(), 0U) << name;
  }
}

/// A word of the PDF and its box in points, y down.
struct Word {
  std::string text;
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
};

std::vector<Word> words_of(const std::string& pdf) {
  const std::string boxes = run_other("pdftotext -bbox " + pdf + " -").out;
  const std::regex word(
      R"re(<word xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">([^<]*)</word>)re");
  std::vector<Word> words;
  for (std::sregex_iterator at(boxes.begin(), boxes.end(), word), end; at != end; ++at) {
    const std::smatch& found = *at;
    words.push_back({found[5], std::stod(found[1]), std::stod(found[2]), std::stod(found[3]),
                     std::stod(found[4])});
  }
  return words;
}

// pdftotext measures words with the fonts in the PDF, and knows nothing of how they were placed.
TEST_F(Exports, NoTwoWordsOfThePdfOverlap) {
  ROOMATLAS_NEEDS("pdftotext");
  const std::vector<Word> words = words_of(exported("-f pdf") + "plan.pdf");
  ASSERT_GT(words.size(), 20U);
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Word& a = words[i];
      const Word& b = words[j];
      // Boxes are as high as the font's lines, which may touch; letters are 0.73 of that.
      const double shrink_a = 0.2 * (a.y1 - a.y0);
      const double shrink_b = 0.2 * (b.y1 - b.y0);
      const bool is_apart = a.x1 <= b.x0 + 0.01 || b.x1 <= a.x0 + 0.01 ||
                            a.y1 - shrink_a <= b.y0 + shrink_b ||
                            b.y1 - shrink_b <= a.y0 + shrink_a;
      EXPECT_TRUE(is_apart) << a.text << " and " << b.text;
    }
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
    if (name.find(' ') != std::string::npos) continue;
    EXPECT_THAT(words, ::testing::Contains(name));
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

TEST_F(Exports, GdalReadsBothGeoJsonsAndTheMap) {
  ROOMATLAS_NEEDS("ogrinfo");
  ROOMATLAS_NEEDS("gdalinfo");
  const std::string out = exported("-f geojson,nav2 --georef 48.0130,7.8335,30");
  for (const char* name : {"plan.local.geojson", "plan.geojson"}) {
    const Outcome info = run_other("ogrinfo -so -al " + out + name);
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("indoor: String"));
    EXPECT_THAT(info.out + info.err, Not(HasSubstr("ERROR")));
  }
  EXPECT_THAT(run_other("ogrinfo -so -al " + out + "plan.geojson").out, HasSubstr("WGS 84"));
  const Outcome map = run_other("gdalinfo " + out + "map.pgm");
  EXPECT_EQ(map.exit_code, 0);
  EXPECT_THAT(map.out, HasSubstr("Size is "));
}

TEST_F(Exports, DxfHasItsLayersInMetres) {
  ROOMATLAS_NEEDS("ogrinfo");
  const Outcome made = run("-q export " + store_ + " -f dxf -o " + (folder_ / "out").string());
  if (made.exit_code == 2) GTEST_SKIP() << made.err;  // a build without GDAL says so
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string dxf = (folder_ / "out").string() + "/plan.dxf";
  const auto count = [&](const std::string& layer) {
    const Outcome found =
        run_other("ogrinfo -q " + dxf +
                  " -sql \"SELECT COUNT(*) AS n FROM entities WHERE Layer = '" + layer + "'\"");
    const std::size_t at = found.out.rfind("= ");
    return at == std::string::npos ? -1 : std::stoi(found.out.substr(at + 2));
  };
  const Json listed = rooms(exported("-f geojson"));
  EXPECT_GT(count("A-WALL"), 0);
  EXPECT_GT(count("A-DOOR"), 0);
  EXPECT_EQ(count("A-AREA-IDEN"), 2 * static_cast<int>(listed.size()));  // name and area
  EXPECT_GE(count("A-AREA"), static_cast<int>(listed.size()));
  EXPECT_THAT(content_of(dxf), HasSubstr("$INSUNITS\n 70\n6\n"));
  EXPECT_THAT(content_of(dxf), HasSubstr(R"(Lab\~<3>\~&\~Kitchen)"));  // blanks of MTEXT
}

TEST_F(Exports, AFormatOfOgrHoldsTheRoomsOfThePlan) {
  ROOMATLAS_NEEDS("ogrinfo");
  const Outcome made =
      run("-q export " + store_ + " -f ogr --ogr GML -o " + (folder_ / "out").string());
  if (made.exit_code == 2) GTEST_SKIP() << made.err;
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome info =
      run_other("ogrinfo -so " + (folder_ / "out").string() + "/plan_GML.gml rooms");
  EXPECT_THAT(info.out,
              HasSubstr("Feature Count: " + std::to_string(rooms(exported("-f geojson")).size())));
  EXPECT_THAT(info.out, HasSubstr("area_m2: Real"));
}

TEST_F(Exports, AnUnknownFormatOfOgrIsAUsageError) {
  const Outcome outcome =
      run("-q export " + store_ + " -f ogr --ogr Nonsense -o " + (folder_ / "out").string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Nonsense"));
}

TEST_F(Exports, NorthIsAsGivenElseAsThePlaceOnEarthSays) {
  const auto arrow = [&](const std::string& options) {
    const std::string svg = content_of(exported("-f svg " + options) + "plan.svg");
    const std::size_t at = svg.find("id=\"north\"");
    return at == std::string::npos ? std::string() : svg.substr(at, 200);
  };
  EXPECT_EQ(arrow(""), "");
  EXPECT_NE(arrow("--north 30"), "");
  EXPECT_EQ(arrow("--north -30"), arrow("--georef 48,7.8,30"));
  EXPECT_EQ(arrow("--north 10"), arrow("--georef 48,7.8,30 --north 10"));
}

TEST_F(Exports, APlaceThatIsNotOnEarthIsAUsageErrorThatNamesTheValueAndItsLimits) {
  const auto complaint = [&](const std::string& place) {
    const Outcome outcome = run("-q export " + store_ + " -f geojson --georef " + place + " -o " +
                                (folder_ / "out").string());
    EXPECT_EQ(outcome.exit_code, 2) << place;
    return outcome.err;
  };
  EXPECT_THAT(complaint("89.9,0,0"), HasSubstr("latitude 89.9 is not in -85 to 85 degrees"));
  EXPECT_THAT(complaint("nan,0,0"), HasSubstr("latitude nan is not in"));
  EXPECT_THAT(complaint("48,181,0"), HasSubstr("longitude 181 is not in -180 to 180 degrees"));
  EXPECT_THAT(complaint("48,11,400"), HasSubstr("heading 400 is not in -360 to 360 degrees"));
  EXPECT_THAT(complaint("148,7,0"), HasSubstr("--georef"));
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
