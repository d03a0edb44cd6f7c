// SPDX-License-Identifier: GPL-3.0-or-later
// What `-o` may replace: a former result, and nothing else.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string kGraph = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";

/// The log of a short mission, simulated once.
std::string log_content() {
  static const std::string content = [] {
    const Folder folder;
    const Outcome made = run("-q simulate " + kTwoRooms + " --sensor laser --max-time 60 -o " +
                             (folder / "m").string());
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return content_of(folder / "m/mission.clf");
  }();
  return content;
}

void expect_refusal(const std::string& arguments, const std::string& mentions) {
  const Outcome outcome = run("-q " + arguments);
  EXPECT_EQ(outcome.exit_code, 3) << arguments << "\n" << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(mentions)) << arguments;
}

TEST(OutputFile, IsNeverTheLogThatIsMapped) {
  const Folder folder;
  const std::string log = folder.write("my.clf", log_content());
  fs::create_symlink(log, folder / "link.clf");
  expect_refusal("map " + log + " -o " + log, "my.clf: is an input");
  expect_refusal("map " + log + " -o " + (folder / "link.clf").string(), "is an input");
  const std::string beside = folder.write("b.gpkg.new", log_content());
  expect_refusal("map " + beside + " -o " + (folder / "b.gpkg").string(), "b.gpkg.new: is an");
  fs::copy_file(log, folder / "building.gpkg");
  expect_refusal("build " + (folder / "building.gpkg").string() + " -o " + (folder / "").string(),
                 "is an input");
  EXPECT_EQ(content_of(log), log_content());
  EXPECT_EQ(content_of(beside), log_content());
  EXPECT_EQ(content_of(folder / "building.gpkg"), log_content());
}

TEST(OutputFile, OfAStoreReplacesAStoreOrAnEmptyFileAlone) {
  const Folder folder;
  const std::string log = folder.write("my.clf", log_content());
  const std::string letter = folder.write("letter.txt", "dear robot");
  expect_refusal("map " + log + " -o " + letter, "letter.txt: is there already and is no store");
  const std::string building = folder.write("building.gpkg", "dear robot");
  expect_refusal("build " + log + " -o " + (folder / "").string(), "building.gpkg: is there");
  EXPECT_EQ(content_of(letter) + content_of(building), "dear robotdear robot");
  const std::string store = folder.write("store.gpkg", "");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run("-q map " + log + " -o " + store).exit_code, 0);
}

TEST(OutputFile, OfAReportIsNeitherTheStoreNorTheTruth) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  const std::string truth = folder / "random/truth.tum";
  const std::string bytes = content_of(store);
  const std::string poses = content_of(truth);
  const std::string report = "report " + store + " --truth " + truth + " -o ";
  expect_refusal(report + store, "building.gpkg: is an input");
  expect_refusal(report + truth, "truth.tum: is an input");
  expect_refusal("evaluate " + store + " --truth " + truth + " --csv " + store, "is an input");
  expect_refusal("evaluate " + store + " --carry " + truth + " --latex " + truth, "is an input");
  EXPECT_EQ(content_of(store), bytes);
  EXPECT_EQ(content_of(truth), poses);
  const std::string page = folder.write("report.html", "a former report");
  EXPECT_EQ(run("-q " + report + page).exit_code, 0);
  EXPECT_THAT(content_of(page), HasSubstr("<html"));
}

TEST(OutputFile, OfTheSolverIsNotItsGraph) {
  const Folder folder;
  const std::string graph = folder.write("in.g2o", kGraph);
  const std::string part = folder.write("out.g2o.part", kGraph);
  const std::string out = folder / "out.g2o";
  expect_refusal("optimize " + graph + " -o " + graph, "in.g2o: is an input");
  expect_refusal("optimize " + graph + " -o " + out + " --covariance " + graph, "is an input");
  expect_refusal("optimize " + part + " -o " + out, "out.g2o.part: is an input");
  EXPECT_EQ(content_of(graph) + content_of(part), kGraph + kGraph);
}

TEST(OutputFile, OfASimulationIsNotItsWorld) {
  const Folder folder;
  fs::copy_file(kTwoRooms, folder / "truth.geojson");
  expect_refusal("simulate " + (folder / "truth.geojson").string() + " --max-time 5 -o " +
                     (folder / "").string(),
                 "truth.geojson: is an input");
  EXPECT_FALSE(fs::exists(folder / "mission.clf"));
}

TEST(OutputFile, IsNoDeviceNoPipeNoFolderAndHasAName) {
  const Folder folder;
  const std::string graph = folder.write("in.g2o", kGraph);
  const std::string log = folder.write("my.clf", log_content());
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "null");
  const std::vector<std::string> commands = {"optimize " + graph + " -o ", "map " + log + " -o "};
  for (const std::string& command : commands) {
    expect_refusal(command + pipe, "special file");
    expect_refusal(command + (folder / "null").string(), "special file");
    expect_refusal(command + (folder / "").string(), "is a directory");
    expect_refusal(command + "''", "no name");
    expect_refusal(command + std::string(300, 'x'), "name too long");
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(folder / "null"));
}

TEST(OutputFile, InAFolderIsNoPipe) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  const std::string pipe = folder / "rooms.csv";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_refusal("export " + store + " -f csv -o " + (folder / "").string(), "rooms.csv");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(OutputFolder, ThatCannotBeMadeIsNamedWithTheReason) {
  const Folder folder;
  const std::string log = folder.write("my.clf", log_content());
  const std::string store = folder / "building.gpkg";
  ASSERT_EQ(run("-q map " + log + " -o " + store).exit_code, 0);
  ASSERT_EQ(run("-q assemble " + store).exit_code, 0);
  const std::string file = folder.write("afile", "");
  const std::vector<std::string> commands = {
      "build " + log, "export " + store, "inspect " + store + " 1",
      "simulate " + kTwoRooms + " --max-time 5", "simulate --random-rooms 3"};
  for (const std::string& command : commands) {
    expect_refusal(command + " -o " + file, "afile: cannot be made as a folder: ");
    expect_refusal(command + " -o " + file + "/x", "afile/x: cannot be made as a folder: ");
    expect_refusal(command + " -o /proc/x", "/proc/x: cannot be made as a folder: ");
    expect_refusal(command + " -o ''", "no name");
    expect_refusal(command + " -o " + std::string(300, 'x'), "name too long");
  }
  expect_refusal("evaluate " + store + " --plots " + file, "afile: cannot be made");
}

}  // namespace
}  // namespace roomatlas::test
