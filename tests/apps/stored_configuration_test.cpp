// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that work on a store take the parameters with which it was made.
#include <gmock/gmock.h>

#include "random_store.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

/// A mission of a minute through two rooms.
std::string mission(const Folder& folder, const std::string& sensor) {
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
  const std::string out = (folder / sensor).string();
  const Outcome simulated =
      run("-q simulate " + world + " --max-time 60 --sensor " + sensor + " -o " + out);
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  return out + "/mission.clf";
}

std::string mapped(const Folder& folder, const std::string& sensor, const std::string& options) {
  const std::string store = (folder / (sensor + ".gpkg")).string();
  const Outcome outcome = run("-q map " + mission(folder, sensor) + " " + options + " -o " + store);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return store;
}

Outcome inspected(const Folder& folder, const std::string& store, const std::string& options = "") {
  const std::string out = (folder / "steps").string();
  const Outcome outcome = run("--json inspect " + store + " 1 " + options + " -o " + out);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome;
}

TEST(StoredConfiguration, InspectDrawsTheRoomAsItWasMapped) {
  const Folder folder;
  const std::string store = mapped(folder, "laser", "--cell 0.05 --line-fit regression");
  const std::string as_mapped = inspected(folder, store).out;
  EXPECT_EQ(as_mapped, inspected(folder, store, "--cell 0.05 --line-fit regression").out);
  EXPECT_NE(as_mapped, inspected(folder, store, "--cell 0.1").out);  // what is given wins
}

TEST(StoredConfiguration, InspectDrawsTheRoomAsTheCorrectionOfSonarsMappedItAgain) {
  const Folder folder;
  const std::string store = mapped(folder, "sonar", "--cell 0.05");
  EXPECT_EQ(inspected(folder, store).out, inspected(folder, store, "--cell 0.05").out);
  ASSERT_EQ(run("-q assemble " + store + " --cell 0.2").exit_code, 0);
  const std::string as_mapped_again = inspected(folder, store).out;
  EXPECT_EQ(as_mapped_again, inspected(folder, store, "--cell 0.2").out);
  EXPECT_NE(as_mapped_again, inspected(folder, store, "--cell 0.05").out);
}

/// The plan as measured after an assembly with these options of its own.
std::string plan_of(const Folder& folder, const std::string& store, const std::string& options) {
  const std::string out = (folder / "plans").string();
  EXPECT_EQ(run("-q assemble " + store + " " + options).exit_code, 0);
  EXPECT_EQ(run("-q export " + store + " --measured-walls -f geojson -o " + out).exit_code, 0);
  return content_of(out + "/plan.local.geojson");
}

TEST(StoredConfiguration, AssembleTakesWhatTheMissionWasMappedWith) {
  const Folder folder;
  for (const char* sensor : {"laser", "sonar"}) {
    const std::string tolerance = "--simplify-tolerance 0.5 --sonar-simplify-tolerance 0.5";
    const std::string finer = "--simplify-tolerance 0.01 --sonar-simplify-tolerance 0.01";
    const std::string options = tolerance + " --wall-thickness 0.4";
    const std::string store = mapped(folder, sensor, options);
    const std::string plan = plan_of(folder, store, "");
    EXPECT_EQ(plan, plan_of(folder, store, options)) << sensor;
    EXPECT_NE(plan, plan_of(folder, store, finer)) << sensor << ": what is given wins";
    EXPECT_NE(plan, plan_of(folder, store, "--wall-thickness 0.2")) << sensor;
    EXPECT_EQ(plan, plan_of(folder, store, "")) << sensor << ": given for one assembly alone";
  }
}

TEST(StoredConfiguration, PlanAndReportTellTheAccuracyWithWhichTheStoreWasAssembled) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  ASSERT_EQ(run("-q assemble " + store + " --odometry-heading 5 --doorway-position 0.5").exit_code,
            0);
  const auto made = [&](const std::string& options) {
    const std::string out = (folder / "out").string();
    EXPECT_EQ(run("-q export " + store + " -f svg,g2o " + options + " -o " + out).exit_code, 0);
    const std::string report = out + "/report.html";
    EXPECT_EQ(run("-q report " + store + " " + options + " -o " + report).exit_code, 0);
    std::vector<std::string> files;
    for (const char* name : {"/plan.svg", "/graph.g2o", "/report.html"}) {
      files.push_back(content_of(out + name));
    }
    return files;
  };
  const auto as_assembled = made("");
  EXPECT_EQ(as_assembled, made("--odometry-heading 5 --doorway-position 0.5"));
  const auto otherwise = made("--odometry-heading 1 --doorway-position 0.05");
  for (std::size_t i = 0; i < otherwise.size(); ++i) EXPECT_NE(as_assembled[i], otherwise[i]) << i;
}

TEST(StoredConfiguration, KeepsEachValueToItsLastDigit) {
  const Folder folder;
  const std::string store = mapped(folder, "laser", "--cell 0.0512345678");
  ASSERT_EQ(run("-q assemble " + store + " --odometry-heading 1.23456789").exit_code, 0);
  auto kept = GeoPackageStore(store, GeoPackageStore::Mode::read).metadata();
  const std::string toml = kept["assembly_configuration"];
  EXPECT_THAT(toml, HasSubstr("\ncell=0.0512345678\n"));
  EXPECT_THAT(toml, HasSubstr("\nodometry-heading=1.23456789\n"));
}

TEST(StoredConfiguration, WhatThisVersionCannotReadIsNamedAndTheRestHolds) {
  const Folder folder;
  const std::string store = mapped(folder, "laser", "");
  const auto keep = [&](const std::string& configuration) {
    GeoPackageStore(store, GeoPackageStore::Mode::update)
        .put_metadata({{"configuration", configuration}});
  };
  keep("cell=0.05\nof-tomorrow=7\n");
  const Outcome unknown = inspected(folder, store);
  EXPECT_THAT(unknown.err, HasSubstr("that this version does not know: of-tomorrow"));
  EXPECT_EQ(unknown.out, inspected(folder, store, "--cell 0.05").out);

  keep("cell=\"wide\"\n");
  const Outcome unreadable = inspected(folder, store);
  EXPECT_THAT(unreadable.err, HasSubstr("this version cannot read the parameters"));
  EXPECT_EQ(unreadable.out, inspected(folder, store, "--cell 0.1").out);

  keep("cell=0.05\ncell=0.2\n");
  const Outcome twice = inspected(folder, store);
  EXPECT_THAT(twice.err, HasSubstr("those of this run hold: cell is given twice"));
  EXPECT_EQ(twice.out, unreadable.out);
}

Outcome built(const Folder& folder, const std::string& log, const std::string& options,
              const std::string& name = "out") {
  const Outcome outcome = run("build " + log + " " + options + " -o " + (folder / name).string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome;
}

constexpr const char* kGoesOn = "holds this mission already";

TEST(StoredConfiguration, BuildGoesOnFromAMapWhereMappingWouldBeTheSame) {
  const Folder folder;
  for (const char* sensor : {"laser", "sonar"}) {
    const std::string log = mission(folder, sensor);
    const std::string changes = "--draw-path --png-dpi 60 --odometry-heading 5";
    (void)built(folder, log, "", sensor);
    EXPECT_THAT(built(folder, log, changes, sensor).err, HasSubstr(kGoesOn));
    const std::string anew = std::string(sensor) + "_anew";
    (void)built(folder, log, changes, anew);
    for (const auto& entry : std::filesystem::directory_iterator(folder / anew)) {
      const auto file = entry.path().filename();
      EXPECT_EQ(content_of(entry.path()), content_of(folder / sensor / file)) << sensor << file;
    }
  }
}

TEST(StoredConfiguration, BuildMapsAgainWhereMappingWouldDiffer) {
  const Folder folder;
  const std::string log = mission(folder, "sonar");
  (void)built(folder, log, "");
  for (const char* change : {"--cell 0.15", "--sonar-cone 20", "--no-correct-sonars"}) {
    EXPECT_EQ(built(folder, log, change).err.find(kGoesOn), std::string::npos) << change;
    (void)built(folder, log, "");
  }
}

}  // namespace
}  // namespace roomatlas::test
