// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <vector>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;

/// Builds from a file of this content; the folder of results must not appear.
Outcome build_from(const std::string& content) {
  const Folder folder;
  const auto log = folder.write("mission.clf", content);
  const Outcome outcome = run("build " + log.string() + " -q -o " + (folder / "out").string());
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  return outcome;
}

void expect_one_line(const Outcome& outcome, int exit_code, const std::string& mentions) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("error: ", 0), 0U) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(mentions), std::string::npos) << outcome.err;
}

std::string scan(double x, double timestamp, double range) {
  std::string line = "FLASER 180";
  for (int i = 0; i < 180; ++i) line += " " + std::to_string(range);
  const std::string pose = " " + std::to_string(x) + " 0 0";
  return line + pose + pose + " " + std::to_string(timestamp) + " host " +
         std::to_string(timestamp) + "\n";
}

TEST(BadInput, AMissingFileIsNamed) {
  expect_one_line(run("build /no/such/mission.clf -o /tmp/never"), 3, "/no/such/mission.clf");
  EXPECT_FALSE(std::filesystem::exists("/tmp/never"));
}

TEST(BadInput, AnEmptyFileIsRefused) { expect_one_line(build_from(""), 3, "empty"); }

TEST(BadInput, ABinaryFileIsRefused) {
  expect_one_line(build_from(std::string("\x7f"
                                         "ELF\0\1\2\0",
                                         8) +
                             std::string(500, '\0')),
                  3, "mission.clf");
}

TEST(BadInput, ATextThatIsNoLogIsRefusedWithTheTagsThatAreKnown) {
  expect_one_line(build_from("dear robot,\nwhere have you been?\n"), 3, "FLASER");
}

TEST(BadInput, ALogWithoutRangesIsNotEnough) {
  std::string log;
  for (int i = 0; i < 50; ++i) {
    log += "ODOM " + std::to_string(0.1 * i) + " 0 0 0.1 0 0 " + std::to_string(i) + " host 0\n";
  }
  expect_one_line(build_from(log), 4, "no range readings");
}

TEST(BadInput, ALogWithoutOdometryIsNotEnough) {
  std::string log;
  for (int i = 0; i < 20; ++i) log += scan(0.0, i, 2.0);
  expect_one_line(build_from(log), 4, "no odometry");
}

TEST(BadInput, ALogWhoseRangesAreAllLeftOutSaysWhyTheFirstOfThemIs) {
  std::string log;
  for (int i = 0; i < 50; ++i) {
    log += "ODOM " + std::to_string(0.1 * i) + " 0 0 0.1 0 0 " + std::to_string(i) + " host 0\n";
    log += "SONAR 0.5 0 " + std::to_string(i) + " host 0\n";
  }
  expect_one_line(build_from(log), 4, "50 SONAR lines, all left out; the first: line 2: SONAR");
}

TEST(BadInput, APipeIsRefusedBecauseALogIsReadMoreThanOnce) {
  const Folder folder;
  const std::string pipe = (folder / "pipe.clf").string();
  ASSERT_EQ(std::system(("mkfifo " + pipe).c_str()), 0);
  expect_one_line(run("build " + pipe + " -q -o " + (folder / "out").string()), 3,
                  "is not a regular file");
}

/// Of the program with its own streams, closed or full.
/// @param before what the shell does first
int exit_code_with(const std::string& arguments, const std::string& before = "") {
  const std::string command = before + std::string(ROOMATLAS_PROGRAM) + " " + arguments;
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(BadInput, IsAnErrorWhereNobodyCanHearOfIt) {
  EXPECT_EQ(exit_code_with("info /nonexistent 2>&-"), 3);
  EXPECT_EQ(exit_code_with("info /nonexistent 2>/dev/full"), 3);
}

TEST(BadInput, AnAnswerThatCannotBePrintedIsAnError) {
  const Folder folder;
  const std::string log = (folder / "two.clf").string();
  std::ofstream(log) << "ODOM 0 0 0 0 0 0 1 host 1\nFLASER 3 1 1 1 0 0 0 0 0 0 1 host 1\n";
  for (const std::string& command : {"--json info " + log, std::string("config --print"),
                                     std::string("--version"), std::string("man")}) {
    EXPECT_EQ(exit_code_with(command + " >/dev/full 2>/dev/null"), 3) << command;
    EXPECT_EQ(exit_code_with(command + " >/dev/null 2>/dev/null"), 0) << command;
    EXPECT_EQ(exit_code_with(command + " 2>/dev/null >&-"), 0) << command;
  }
}

TEST(BadInput, TwoOutputsNeedTwoNames) {
  const Folder folder;
  const std::string graph = (folder / "graph.g2o").string();
  std::ofstream(graph) << "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n"
                          "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";
  const std::string out = (folder / "out.g2o").string();
  const std::string same = (folder / "." / "out.g2o").string();
  const Outcome outcome = run("optimize " + graph + " -o " + out + " --covariance " + same);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("is named for two outputs"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(BadInput, DevicesAndPipesWithoutAnEndAreRefused) {
  const Folder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string world = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/two_rooms.geojson";
  const std::string out = " -o " + (folder / "out").string();
  EXPECT_THAT(run("--config /dev/zero simulate " + world + out).err, HasSubstr("is a device"));
  EXPECT_THAT(run("optimize /dev/zero" + out).err, HasSubstr("is a device"));
  std::vector<std::future<std::string>> refusals;  // each waits some seconds: side by side
  for (const std::string& command :
       {"--config " + pipe + " simulate " + world + out, "optimize " + pipe + out,
        "simulate " + world + " --drive " + pipe + out}) {
    refusals.push_back(
        std::async(std::launch::async, [command] { return command + ": " + run(command).err; }));
  }
  for (auto& refusal : refusals) {
    EXPECT_THAT(refusal.get(), HasSubstr("is a pipe from which nothing came"));
  }
  for (const std::string& command : {"evaluate " + pipe, "info " + pipe, "build " + pipe + out}) {
    EXPECT_THAT(run(command).err, HasSubstr("not a regular file")) << command;
  }

  // A pipe with something in it is as good as a file.
  const std::string graph =
      R"(VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n)";
  EXPECT_EQ(exit_code_with("-q optimize " + pipe + " -o " + (folder / "graph.g2o").string(),
                           "printf '" + graph + "' > " + pipe + " & "),
            0);
  EXPECT_EQ(exit_code_with("--config " + pipe + " config --print | grep -q '^cell=0.2'",
                           "echo cell=0.2 > " + pipe + " & "),
            0);
}

TEST(BadInput, AFileThatMayNotGrowIsAnErrorOfWriting) {
  const Folder folder;
  std::string log;
  for (int i = 0; i < 500; ++i) log += scan(0.1 * i, i, 2.0);
  const std::string arguments = "convert " + folder.write("mission.clf", log).string() + " -o " +
                                (folder / "large.clf").string() + " 2>/dev/null";
  EXPECT_EQ(exit_code_with(arguments, "ulimit -f 8; "), 3);
}

TEST(StandardStreams, ThatAreClosedGetIntoNoFile) {
  const Folder folder;
  std::string log;
  for (int i = 0; i < 50; ++i) log += scan(0.1 * i, i, 2.0);
  const std::string made = "convert " + folder.write("mission.clf", log).string() + " -o ";
  const std::string open = (folder / "open.clf").string();
  const std::string closed = (folder / "closed.clf").string();
  EXPECT_EQ(exit_code_with(made + open + " >/dev/null 2>&1"), 0);
  EXPECT_EQ(exit_code_with(made + closed + " <&- >&- 2>&-"), 0);
  EXPECT_EQ(content_of(closed), content_of(open));
}

TEST(BadInput, AMissionThatSawNoWallIsNotEnough) {
  std::string log;
  for (int i = 0; i < 50; ++i) log += scan(0.1 * i, i, 81.91);
  const Outcome outcome = build_from(log);
  expect_one_line(outcome, 4, "no wall was seen");
}

TEST(BadInput, AMissionThatSawNoWallLeavesNoneOfTheFoldersItMade) {
  std::string log;
  for (int i = 0; i < 50; ++i) log += scan(0.1 * i, i, 81.91);
  const Folder folder;
  const auto file = folder.write("mission.clf", log);
  for (const char* out : {"a/b/c", "a/b/c/"}) {
    EXPECT_EQ(run("build " + file.string() + " -q -o " + (folder / out).string()).exit_code, 4);
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
  }
}

TEST(BadInput, AMissionThatSawNoWallLeavesTheStoreThatWasThere) {
  std::string log;
  for (int i = 0; i < 50; ++i) log += scan(0.1 * i, i, 81.91);
  const Folder folder;
  const auto file = folder.write("mission.clf", log);
  const std::string former = "SQLite format 3: the map of an earlier mission";
  const auto store = folder.write("building.gpkg", former);
  EXPECT_EQ(run("map " + file.string() + " -q -o " + store.string()).exit_code, 4);
  EXPECT_EQ(content_of(store), former);
  EXPECT_FALSE(std::filesystem::exists(store.string() + ".new"));
}

/// A robot that turns as it drives, and hears something at half a step from it all around.
std::string readings_that_enclose_nothing() {
  std::string log;
  for (int i = 0; i < 6; ++i) {
    const std::string pose = " " + std::to_string(0.5 * i) + " 0 " + std::to_string(0.3 * i) + " ";
    log += "FLASER 180";
    for (int k = 0; k < 180; ++k) log += " 0.40";
    log += pose + pose + std::to_string(i) + " host " + std::to_string(i) + "\n";
  }
  return log;
}

TEST(BadInput, APlanWithoutRoomsIsWrittenAndNotEnough) {
  const Folder folder;
  const auto log = folder.write("mission.clf", readings_that_enclose_nothing());
  const std::string out = folder / "out";
  expect_one_line(run("build " + log.string() + " -q --as-sonar -o " + out), 4, "no room");
  EXPECT_NE(content_of(out + "/summary.json").find("\"rooms\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(out + "/plan.svg"));
  EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));
  expect_one_line(run("-q assemble " + out + "/building.gpkg"), 4,
                  "building.gpkg: the plan has no");
}

TEST(BadInput, AWrongCommandLineIsAUsageError) {
  for (const char* arguments :
       {"", "fly", "build", "build x.clf", "build x.clf -o y --no-such-option 1",
        "build x.clf -o y --cell 7", "export x.gpkg -f gif -o y"}) {
    EXPECT_EQ(run(arguments).exit_code, 2) << arguments;
  }
}

TEST(BadInput, AnUnknownKeyInTheConfigurationIsAUsageError) {
  const Folder folder;
  const auto config = folder.write("config.toml", "no-such-key=1\n");
  EXPECT_EQ(run("--config " + config.string() + " config --print").exit_code, 2);
}

TEST(BadInput, AStoreThatIsNoneIsNamed) {
  const Folder folder;
  const auto file = folder.write("x.gpkg", "not a database");
  expect_one_line(run("-q assemble " + file.string()), 3, "x.gpkg");
}

TEST(Help, SaysWhoseGridTheCellIs) {
  EXPECT_NE(run("config --print").out.find("cell of the HIMM grid"), std::string::npos);
}

TEST(Help, AndVersionAndConfigurationAnswer) {
  EXPECT_EQ(run("--help").exit_code, 0);
  EXPECT_EQ(run("build --help").exit_code, 0);
  EXPECT_EQ(run("--version").exit_code, 0);
  const Outcome defaults = run("config --print");
  EXPECT_EQ(defaults.exit_code, 0);
  const Folder folder;
  const auto file = folder.write("config.toml", defaults.out);
  const Outcome again = run("--config " + file.string() + " config --print");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(defaults.out.find("heading-bias=true"), std::string::npos);
  EXPECT_NE(again.out.find("heading-bias=true"), std::string::npos);
}

}  // namespace
}  // namespace roomatlas::test
