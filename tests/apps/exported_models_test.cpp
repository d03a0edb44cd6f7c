// SPDX-License-Identifier: GPL-3.0-or-later
// Building models, indoor maps and drawings that `export` writes, as other programs see them.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "exports.hpp"
#include "io/plans/imdf_rules.hpp"
#include "io/plans/step_entities.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using ExportedModels = Exports;

// ezdxf's audit checks what a CAD program would stumble over.
TEST_F(ExportedModels, EzdxfFindsNoFaultInTheDxfAndABlockInEachDoor) {
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

TEST_F(ExportedModels, GdalReadsEachLayerOfTheImdfArchiveWithItsFeatures) {
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

TEST_F(ExportedModels, AnImdfArchiveWithoutAPlaceOrAnAddressSaysWhatItHasInstead) {
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

[[maybe_unused]] ForeignModel model_of(const std::string& listing) {
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

TEST_F(ExportedModels, IfcIsReadByIfcPlusPlusWithWallsThatDoorsAreCutOutOf) {
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

TEST_F(ExportedModels, ARoomHasTheSameIdentifierInImdfAfterItIsRenamed) {
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

TEST_F(ExportedModels, XpathFindsRoomsAndDoorsOfTheDrawingByIdAndTitle) {
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

}  // namespace
}  // namespace roomatlas::test
