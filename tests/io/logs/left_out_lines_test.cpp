// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using test::read_text;
using test::ReadLog;
using test::times;
using ::testing::HasSubstr;

/// What the log lacks, and why; empty where it lacks nothing.
std::string missed(const std::string& text) {
  try {
    require_lines_that_could_be_read(read_text(text).info);
  } catch (const NotEnoughError& error) {
    return error.what();
  }
  return "";
}

const std::string kOdometry = "ODOM 0 0 0 0 0 0 1 h 0\n";

TEST(LeftOutLines, ThatWereAllRangesAreCountedAndTheFirstIsExplained) {
  const std::string scan = "FLASER 2 1 1 nan 0 0 0 0 0 1 h 0\n";
  EXPECT_EQ(missed(kOdometry + scan + scan + scan),
            "mission.clf: no range readings: 3 FLASER lines, all left out; the first: line 2: "
            "FLASER laser x: expected a finite number, found 'nan'");
  EXPECT_EQ(missed(kOdometry + "SONAR 0.5 0 1 h 0\n"),
            "mission.clf: no range readings: 1 SONAR lines, all left out; the first: line 2: "
            "SONAR number of readings: expected at least 1, found 0");
}

TEST(LeftOutLines, ThatWereAllRangesOfADpSlamLogAreCounted) {
  EXPECT_THAT(
      missed("Odometry 1 2 0.5\nLaser 181 3 3\n"),
      HasSubstr("no range readings: 1 Laser lines, all left out; the first: line 2: range"));
}

TEST(LeftOutLines, ThatWereAllOdometryAreCountedAndTheFirstIsExplained) {
  EXPECT_EQ(missed("ODOM 1,5 0 0 0 0 0 1 h 0\nSONAR 0.5 1 2 0 0 0 1 h 0\n"),
            "mission.clf: no odometry: 1 ODOM lines, all left out; the first: line 1: ODOM x: "
            "expected a finite number, found '1,5'");
}

TEST(LeftOutLines, AreTheFirstOfTheIssues) {
  const ReadLog log = read_text(kOdometry + "FLASER x\n");
  EXPECT_EQ(log.info.issues.at(0).severity, Severity::error);
  EXPECT_THAT(to_string(log.info.issues.at(0)), HasSubstr("1 FLASER lines, all left out"));
}

TEST(LeftOutLines, AreNoErrorWhereOthersCouldBeRead) {
  const std::string good = "FLASER 180" + times(180, "1") + " 0 0 0 1 0 0 1 h 0\n";
  EXPECT_EQ(missed(good + "FLASER x\nODOM x\nSONAR x\n"), "");
  EXPECT_EQ(missed(kOdometry), "");  // there were none
}

}  // namespace
}  // namespace roomatlas
