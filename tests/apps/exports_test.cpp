// SPDX-License-Identifier: GPL-3.0-or-later
// The files that `export` writes, as other programs see them.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "io/plans/imdf_rules.hpp"
#include "io/plans/step_entities.hpp"
#include "random_store.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"

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
    const Json plan = Json::parse(content_of(out + "plan.local.geojson"));
    for (const Json& feature : plan["features"]) {
      if (feature["properties"].contains("area_m2")) found.push_back(feature["properties"]);
    }
    return found;
  }

  Folder folder_;
  std::string store_;
};

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

TEST_F(Exports, XpathFindsRoomsAndDoorsOfTheDrawingByIdAndTitle) {
  ROOMATLAS_NEEDS("xmllint");
  const std::string out = exported("-f svg,geojson");
  const auto found = [&](const std::string& path) {
    return run_other("xmllint --xpath \"" + path + "\" " + out + "plan.svg").out;
  };
  EXPECT_THAT(found("string(//*[@id='room-3']/*[local-name()='title'])"),
              HasSubstr("Lab <3> & Kitchen, "));
  for (const Json& room : rooms(out)) {
    const std::string id = std::to_string(room["id"].get<int>());
    EXPECT_EQ(std::stoi(found("count(//*[@id='room-" + id + "'])")), 1);
    EXPECT_NEAR(std::stod(found("string(//*[@id='room-" + id + "']/@data-area-m2)")),
                room["area_m2"].get<double>(), 1e-3);
  }
  const FloorPlan plan = read_plan(out + "plan.local.geojson");
  EXPECT_EQ(std::stoul(found("count(//*[@id='doors']/*[starts-with(@id,'door-')]"
                             "/*[local-name()='title'])")),
            plan.doors.size());
  // Each id once: as many as there are different ones.
  EXPECT_EQ(found("count(//*[@id])"), found("count(//*[@id and not(@id = preceding::*/@id) and "
                                            "not(@id = ancestor::*/@id)])"));
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

// ezdxf's audit checks what a CAD program would stumble over.
TEST_F(Exports, EzdxfFindsNoFaultInTheDxfAndABlockInEachDoor) {
  const std::string python = "/usr/bin/python3";  // whose packages are the system's
  if (run_other(python + " -c 'import ezdxf'").exit_code != 0) {
    const char* ci = std::getenv("CI");
    if (ci != nullptr && std::string(ci) == "true") FAIL() << "python3-ezdxf is missing";
    GTEST_SKIP() << "python3-ezdxf is missing";
  }
  const Outcome made = run("-q export " + store_ + " -f dxf -o " + (folder_ / "out").string());
  if (made.exit_code == 2) GTEST_SKIP() << made.err;
  const std::string script =
      folder_
          .write("audit.py",
                 "import ezdxf, sys\n"
                 "drawing = ezdxf.readfile(sys.argv[1])\n"
                 "audit = drawing.audit()\n"
                 "inserts = drawing.modelspace().query('INSERT')\n"
                 "known = all(i.dxf.name in drawing.blocks for i in inserts)\n"
                 "print(len(audit.errors), len(audit.fixes), len(inserts), known)\n")
          .string();
  const Outcome told =
      run_other(python + " " + script + " " + (folder_ / "out" / "plan.dxf").string());
  const FloorPlan plan = read_plan(exported("-f geojson") + "plan.local.geojson");
  EXPECT_EQ(told.out, "0 0 " + std::to_string(plan.doors.size()) + " True\n") << told.err;
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

TEST_F(Exports, GdalReadsEachLayerOfTheImdfArchiveWithItsFeatures) {
  ROOMATLAS_NEEDS("ogrinfo");
  const std::string out =
      exported("-f imdf,geojson --georef 48.0130,7.8335,30 --address 'Am Ring 5;Freiburg;DE'");
  const std::map<std::string, std::string> files = unzipped(content_of(out + "plan.imdf.zip"));
  for (const auto& [name, content] : files) {
    if (name == "manifest.json") continue;
    const Outcome info = run_other("ogrinfo -so -al /vsizip/" + out + "plan.imdf.zip/" + name);
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_THAT(info.out + info.err, Not(HasSubstr("ERROR")));
    EXPECT_THAT(info.out, HasSubstr("Feature Count: " +
                                    std::to_string(Json::parse(content)["features"].size())));
    EXPECT_THAT(info.out, HasSubstr("id: String"));
  }
  EXPECT_THAT(files.at("address.geojson"), HasSubstr("Freiburg"));
  const Outcome units = run_other("ogrinfo -so -al /vsizip/" + out + "plan.imdf.zip/unit.geojson");
  EXPECT_THAT(units.out, HasSubstr("WGS 84"));
  EXPECT_THAT(broken_imdf_rules(imdf_files(content_of(out + "plan.imdf.zip"))),
              ::testing::IsEmpty());
  for (const Json& room : rooms(out)) {
    EXPECT_THAT(files.at("unit.geojson"),
                HasSubstr("\"name\":{\"en\":" + room["name"].dump() + "}"));
  }
}

TEST_F(Exports, AnImdfArchiveWithoutAPlaceOrAnAddressSaysWhatItHasInstead) {
  const std::string out = (folder_ / "out").string();
  const Outcome told = run("export " + store_ + " -f imdf -o " + out);
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_THAT(told.err, HasSubstr("--georef LAT,LON,HEADING"));
  EXPECT_THAT(told.err, HasSubstr("--address"));
  const Outcome wrong = run("export " + store_ + " -f imdf --address 'Am Ring 5' -o " + out);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("STREET;CITY;COUNTRY"));
}

/// What IfcPlusPlus found: entities by kind, solids as "kind id volume highest", complaints.
struct ForeignModel {
  std::map<std::string, int> count;
  std::map<std::string, double> volume_m3;  ///< of all solids of a kind
  std::map<std::string, int> solids;
  double highest_m = 0.0;
  int complaints = 0;
};

ForeignModel model_of(const std::string& listing) {
  ForeignModel model;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, kind, id;
    words >> first;
    if (first == "solid") {
      double volume_m3 = 0.0;
      double highest_m = 0.0;
      words >> kind >> id >> volume_m3 >> highest_m;
      model.volume_m3[kind] += volume_m3;
      model.highest_m = std::max(model.highest_m, highest_m);
      ++model.solids[kind];
    } else if (first == "complaint") {
      ++model.complaints;
    } else {
      words >> model.count[first];
    }
  }
  return model;
}

TEST_F(Exports, IfcIsReadByIfcPlusPlusWithWallsThatDoorsAreCutOutOf) {
  const std::string out = exported("-f ifc,geojson --storey-height 3");
  EXPECT_THAT(broken_ifc_rules(content_of(out + "plan.ifc")), ::testing::IsEmpty());
#ifdef ROOMATLAS_READ_IFC
  const Outcome read = run_other(std::string(ROOMATLAS_READ_IFC) + " " + out + "plan.ifc");
  ASSERT_EQ(read.exit_code, 0) << read.err;
  ForeignModel model = model_of(read.out);
  EXPECT_EQ(model.complaints, 0) << read.out;
  const Json listed = rooms(out);
  EXPECT_EQ(model.solids["IfcSpace"], static_cast<int>(listed.size()));
  double area_m2 = 0.0;
  for (const Json& room : listed) area_m2 += room["area_m2"].get<double>();
  EXPECT_NEAR(model.volume_m3["IfcSpace"], 3.0 * area_m2, 0.01 * area_m2);
  EXPECT_DOUBLE_EQ(model.highest_m, 3.0);
  EXPECT_EQ(model.count["IfcRelVoidsElement"], model.count["IfcOpeningElement"]);
  EXPECT_GT(model.count["IfcDoor"], 0);
  EXPECT_GE(model.count["IfcRelFillsElement"], model.count["IfcDoor"]);
  // Walls of a plan with doors as gaps, and above each door what is between its head and the
  // ceiling.
  double walls_m3 = 0.0;
  const FloorPlan plan = read_plan(out + "plan.local.geojson");
  for (const Polygon& wall : plan.walls) walls_m3 += 3.0 * area(wall);
  for (const PlanDoor& door : plan.doors) {
    const double hole_m = door.kind == DoorKind::window ? 1.2 : 2.1;
    walls_m3 += (3.0 - hole_m) * std::abs(signed_area(door.opening));
  }
  EXPECT_NEAR(model.volume_m3["IfcWall"], walls_m3, 0.01 * walls_m3);
#else
  GTEST_SKIP() << "IfcPlusPlus (libifcplusplus-dev) was not there when this was built";
#endif
}

TEST_F(Exports, ARoomHasTheSameIdentifierInImdfAfterItIsRenamed) {
  const auto ids = [&] {
    std::set<std::string> found;
    const ImdfFiles files = imdf_files(content_of(exported("-f imdf") + "plan.imdf.zip"));
    for (const Json& unit : imdf_features(files, "unit")) found.insert(unit["id"]);
    return found;
  };
  const std::set<std::string> before = ids();
  ASSERT_EQ(run("-q rename " + store_ + " 3 Office").exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store_).exit_code, 0);
  EXPECT_EQ(ids(), before);
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
