// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

/// A drive as TUM, later by `offset_s`, with times in other units, off by a wave of `error_m`.
std::string tum(double error_m, double offset_s = 0.0, double per_second = 1.0, int poses = 60) {
  std::string text;
  for (int i = 0; i < poses; ++i) {
    text += std::to_string((100.0 + i + offset_s) * per_second) + " " + std::to_string(0.3 * i) +
            " " + std::to_string(error_m * std::sin(0.5 * i)) + " 0 0 0 0 1\n";
  }
  return text;
}

std::string without_lines_of(const std::string& text, const std::string& tag) {
  std::istringstream lines(text);
  std::string left;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(tag)) left += line + "\n";
  }
  return left;
}

constexpr const char* kRelations = "100 110 3 0 0 0 0 0\n105 150 13.5 0 0 0 0 0\n";

TEST(Evaluate, ComparesTrajectoriesInOneTable) {
  const Folder folder;
  folder.write("a.tum", tum(0.5));
  folder.write("b.tum", tum(0.05));
  folder.write("t.tum", tum(0.0));
  const std::string at = folder / "";
  const Outcome outcome =
      run("evaluate " + at + "a.tum " + at + "b.tum --truth " + at + "t.tum --csv " + at +
          "o.csv --latex " + at + "o.tex --plots " + at + "plots --archive " + at + "o.zip");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("APE, trans_part (m)"));
  EXPECT_THAT(outcome.out, HasSubstr("than the first run: better"));
  for (const char* file : {"o.csv", "o.tex", "plots/ape_over_time.svg", "plots/ape_histogram.svg",
                           "plots/map_ape_a.tum.svg", "o-b.tum-ape.zip", "o-b.tum-rpe.zip"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  }
}

TEST(Evaluate, GivesJsonWithTheSameFigures) {
  const Folder folder;
  folder.write("a.tum", tum(0.5));
  const std::string truth = folder.write("t.relations", kRelations);
  const Outcome outcome =
      run("evaluate --json " + (folder / "a.tum").string() + " --truth " + truth);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["runs"][0]["figures"][0]["covered"], 2);
}

/// The message of a run that must fail, with one file to judge and one of truth.
std::string failure(const std::string& judged, const std::string& truth_name,
                    const std::string& truth, int exit_code, const std::string& flags = "") {
  const Folder folder;
  const std::string judged_file = folder.write("run.tum", judged);
  const std::string truth_file = folder.write(truth_name, truth);
  const Outcome outcome = run("evaluate " + judged_file + " --truth " + truth_file + " " + flags);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  return outcome.err;
}

TEST(Evaluate, NamesTheLikelyCauseWhenNothingCanBeJudged) {
  EXPECT_THAT(failure(tum(0.1, 5000.0), "t.relations", kRelations, 4),
              HasSubstr("--time-offset -5000.000"));
  EXPECT_THAT(failure(tum(0.1, 0.0, 1e9), "t.relations", kRelations, 4), HasSubstr("nanoseconds"));
  EXPECT_THAT(failure(tum(0.1, 0.25), "t.relations", kRelations, 4), HasSubstr("--match nearest"));
  EXPECT_THAT(failure(tum(0.1), "t.relations", "# none\n", 3), HasSubstr("holds no relation"));
  EXPECT_THAT(failure(tum(0.1), "t.relations", "100 110 3 0 0 0 0 45\n", 3), HasSubstr("degrees"));
  EXPECT_THAT(failure("100 nan 0 0 0 0 0 1\n", "t.relations", kRelations, 3),
              HasSubstr("run.tum:1: tx: expected a finite number"));
  EXPECT_THAT(failure(tum(0.1, 0.0, 1.0, 1), "t.relations", kRelations, 4),
              HasSubstr("have no pose at one of their timestamps"));
  EXPECT_THAT(failure(tum(0.1), "t.relations", kRelations, 2, "--pose-offset 0,0,45"),
              HasSubstr("looks like degrees"));
  EXPECT_THAT(failure(tum(0.1), "t.tum", tum(0.0), 2, "--delta 1.5"), HasSubstr("--delta"));
}

/// A small simulated mission, mapped: building.gpkg and mission/truth.geojson.
const Folder& two_rooms() {
  static const Folder folder;
  static const bool is_made = [] {
    const std::string at = folder / "";
    EXPECT_EQ(run("-q simulate " + kTwoRooms + " --sensor laser -o " + at + "mission").exit_code,
              0);
    EXPECT_EQ(run("-q build " + at + "mission/mission.clf -o " + at + "a").exit_code, 0);
    EXPECT_EQ(
        run("-q build " + at + "mission/mission.clf --model rotation -o " + at + "b").exit_code, 0);
    return true;
  }();
  EXPECT_TRUE(is_made);
  return folder;
}

TEST(Evaluate, OfOneStoreHasTheShapeOfAComparisonWithIntervals) {
  const std::string at = two_rooms() / "";
  const Outcome outcome =
      run("evaluate --json " + at + "a/building.gpkg --truth " + at + "mission/truth.geojson");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["runs"].size(), 2U);
  EXPECT_EQ(json["runs"][1]["name"], "building.gpkg corrected");
  EXPECT_TRUE(json["runs"][0]["figures"][0].contains("interval"));
  EXPECT_TRUE(json["runs"][1]["figures"][0].contains("less_first"));
  ASSERT_EQ(json["plans"].size(), 1U);
  EXPECT_EQ(json["plans"][0]["plan"]["true_rooms"], 2);
  EXPECT_TRUE(json["plans"][0].contains("consistency"));
}

TEST(Evaluate, OfAStoreWithoutAnyTruthStillHasThatShape) {
  const Folder folder;
  const std::string log = two_rooms() / "mission/mission.clf";
  const std::string blind = folder.write("blind.clf", without_lines_of(content_of(log), "TRUEPOS"));
  ASSERT_EQ(run("-q build " + blind + " -o " + (folder / "out").string()).exit_code, 0);
  const std::string store = folder / "out/building.gpkg";
  const auto json = nlohmann::json::parse(run("evaluate --json " + store).out);
  EXPECT_TRUE(json["runs"][0]["figures"].empty());
  EXPECT_EQ(json["plans"][0]["consistency"]["figures"].size(), 8U);
  const Outcome plots = run("evaluate " + store + " --plots " + (folder / "plots").string());
  EXPECT_EQ(plots.exit_code, 2);
  EXPECT_THAT(plots.err, HasSubstr("there are none"));
}

TEST(Evaluate, PutsPlansOfSeveralRunsAndToolsIntoOneTable) {
  const Folder folder;
  const std::string at = two_rooms() / "";
  const std::string csv = folder / "o.csv";
  const std::string latex = folder / "o.tex";
  const Outcome outcome =
      run("evaluate " + at + "a/building.gpkg " + at + "b/building.gpkg " + kTwoRooms +
          " --truth " + at + "mission/truth.geojson --csv " + csv + " --latex " + latex);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("rooms: f1 at IoU 0.5"));
  EXPECT_THAT(outcome.out, HasSubstr("walls: plan to truth, median (m)"));
  EXPECT_THAT(outcome.out, HasSubstr("two_rooms.geojson: laid on the truth by"));
  const std::string table = content_of(csv);
  EXPECT_THAT(table, HasSubstr("two_rooms.geojson,rooms,,f1 at IoU 0.5,,,,,,1,"));
  EXPECT_THAT(table, HasSubstr("two_rooms.geojson,graph,,edits,,,,,,0,"));
  EXPECT_THAT(table, HasSubstr("two_rooms.geojson,doors,,recall,,1,1,,,1,"));
  EXPECT_THAT(content_of(latex), HasSubstr("graph: isomorphic & "));
}

TEST(Evaluate, RefusesAPlanWithoutATrueOneAndATrueOneWithoutRooms) {
  const Folder folder;
  const std::string empty =
      folder.write("empty.geojson", R"({"type":"FeatureCollection","features":[],)"
                                    R"("roomatlas":{"schema":"plan","version":1,"units":"m"}})");
  const Outcome alone = run("evaluate " + kTwoRooms);
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("judged by a true plan"));
  const Outcome against_nothing = run("evaluate " + kTwoRooms + " --truth " + empty);
  EXPECT_EQ(against_nothing.exit_code, 3);
  EXPECT_THAT(against_nothing.err, HasSubstr("holds no room"));
}

TEST(Evaluate, TellsWhatTruthIsWhenJsonIsOfAnotherProgram) {
  for (const char* other : {"{}", "[1]", R"({"type":"Feature"})"}) {
    const std::string said = failure(tum(0.1), "t.geojson", other, 3);
    EXPECT_THAT(said, HasSubstr("t.geojson: is neither a plan of this program nor a "
                                "FeatureCollection of rooms"));
    EXPECT_THAT(said, HasSubstr("known are plans (plan.local.geojson"));
    EXPECT_THAT(said, HasSubstr(".relations"));
  }
  EXPECT_THAT(failure(tum(0.1), "t.geojson", R"({"type":"FeatureCollection","features":[]})", 3),
              HasSubstr("holds no polygon that is a room"));
  EXPECT_THAT(failure(tum(0.1), "t.geojson", R"({"type":"FeatureCollection","roomatlas":{}})", 3),
              HasSubstr("roomatlas.schema: missing"));
  EXPECT_THAT(failure(tum(0.1), "t.geojson", "{", 3), HasSubstr("not valid JSON"));
}

TEST(Evaluate, TellsWhenOnePoseOnlyIsJudged) {
  const Folder folder;
  const std::string one = folder.write("one.tum", tum(0.1, 0.0, 1.0, 1));
  const std::string truth = folder.write("t.tum", tum(0.0));
  const Outcome outcome = run("evaluate " + one + " --truth " + truth);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("one pose only"));
}

}  // namespace
}  // namespace roomatlas::test
