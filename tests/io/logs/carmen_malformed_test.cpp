// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include <gmock/gmock.h>

namespace roomatlas {
namespace {

using test::read_text;
using test::ReadLog;
using test::texts;
using test::times;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kGood = "FLASER 2 7 8 1 2 3 1 2 3 5 h 0\n";

/// Reads `line` between two good ones; the one issue that it makes.
std::string issue_of(const std::string& line) {
  const ReadLog log = read_text(kGood + line + "\n" + kGood);
  EXPECT_EQ(log.readings.size(), 2U) << line;
  EXPECT_EQ(log.info.malformed_lines, 1) << line;
  EXPECT_EQ(log.info.line_counts.at("FLASER"), 2) << line;
  std::string text;
  for (const Issue& issue : log.info.issues) {
    if (issue.line == 2) text += to_string(issue);
  }
  return text;
}

TEST(MalformedLine, AnAnnouncedNumberOfReadingsThatTheLineDoesNotHaveIsNamed) {
  EXPECT_THAT(issue_of("FLASER 361" + times(240, "1.5")),
              StartsWith("mission.clf:2: FLASER announces 361 readings but the line has 240 numbers"
                         "; the line is left out"));
  EXPECT_THAT(issue_of("FLASER 1 1 2 3 4 5 6 7 8 9 10 h 0"), HasSubstr("announces 1 readings"));
  EXPECT_THAT(issue_of("FLASER 12 1 2 1 2 3 1 2 3 9 h 0"), HasSubstr("announces 12 readings"));
  EXPECT_THAT(issue_of("SONAR 0.5 2 1 1 0 0 0"), HasSubstr("SONAR announces 2 readings"));
  EXPECT_THAT(issue_of("FLASER 18446744073709551615 1 2"), HasSubstr("but the line has 2 numbers"));
}

TEST(MalformedLine, NumbersBehindTheReadingsThatMayBeAPoseOrATimeAreNotGuessed) {
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 3"), HasSubstr("FLASER announces 2 readings"));
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2"), HasSubstr("FLASER announces 2 readings"));
}

TEST(MalformedLine, AnglesInDegreesAreNamedWithTheUnitThatIsExpected) {
  const std::string end = "50 0.01 0 181" + times(181, "1") + " 0 1 2 3 1 2 3 0 0 0 0 0 9 h 0";
  EXPECT_THAT(issue_of("ROBOTLASER1 0 -90 180 1 " + end),
              HasSubstr("ROBOTLASER1 start_angle: expected radians, found -90, more than a turn, "
                        "which looks like degrees; the line is left out"));
  EXPECT_THAT(issue_of("ROBOTLASER1 0 -1.5708 3.1416 1 " + end),
              HasSubstr("ROBOTLASER1 fov, step: expected radians, found 181 readings 1 apart, more "
                        "than a turn, which looks like degrees; the line is left out"));
  EXPECT_THAT(issue_of("ROBOTLASER1 0 -1.5708 3.1416 1e6 " + end), HasSubstr("1e+06 apart"));
  EXPECT_THAT(issue_of("ROBOTLASER1 0 0 180 0 " + end), HasSubstr("181 readings 1 apart"));
}

TEST(MalformedLine, AWholeTurnOfReadingsIsNot) {
  const ReadLog log = read_text(
      "ODOM 0 0 0 0 0 0 1 h 0\nRAWLASER1 0 3.14159265 0 -0.0174532925 "
      "50 0.01 0 361" +
      times(361, "1") + " 0 1 h 0\n");
  EXPECT_EQ(log.readings.size(), 1U);
  EXPECT_THAT(log.info.issues, IsEmpty());
}

TEST(MalformedLine, WhatIsNotANumberIsNamedWithItsField) {
  EXPECT_THAT(issue_of("FLASER 3 1 2.x 3 1 2 3 1 2 3 9 h 0"),
              StartsWith("mission.clf:2: FLASER reading 2: expected a number, found '2.x'"));
  EXPECT_THAT(issue_of("FLASER two 1 2 1 2 3 1 2 3 9 h 0"),
              HasSubstr("FLASER number of readings: expected a whole number, found 'two'"));
  EXPECT_THAT(issue_of("FLASER -2 1 2 1 2 3 1 2 3 9 h 0"), HasSubstr("found '-2'"));
  EXPECT_THAT(issue_of("FLASER 0 1 2 3 1 2 3 9 h 0"), HasSubstr("expected at least 1, found 0"));
  EXPECT_THAT(issue_of("ODOM 1 abc 3 0 0 0 9 h 0"),
              HasSubstr("ODOM y: expected a finite number, found 'abc'"));
  EXPECT_THAT(issue_of("ODOM 1 2"),
              HasSubstr("ODOM theta: expected a finite number, found the end"));
  EXPECT_THAT(issue_of("TRUEPOS 1 2 3 4 5 6 noon h 0"), HasSubstr("TRUEPOS timestamp"));
  EXPECT_THAT(issue_of("ODOM 1 2 3 0 0 0 9 h 0 0 0"), HasSubstr("ODOM has 2 fields too many"));
  EXPECT_THAT(issue_of("ROBOTLASER1 0 0 0 0 9 0 0 2 1 1 0 9 h 0"), HasSubstr("ROBOTLASER1 step"));
  EXPECT_THAT(issue_of("ROBOTLASER1 0 0 1"), HasSubstr("ROBOTLASER1 step"));
  EXPECT_THAT(
      issue_of("PARAM robot_width wide 0 h 0"),
      HasSubstr("PARAM robot_width: expected a length in metres from 0.05 to 5, found 'wide'"));
  EXPECT_THAT(issue_of("PARAM"), HasSubstr("PARAM name: expected a name"));
}

TEST(MalformedLine, APoseThatIsNotFiniteIsRefusedButARangeMayBe) {
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 nan 1 2 3 5 h 0"),
              HasSubstr("FLASER laser theta: expected a finite number, found 'nan'"));
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 3 1 inf 3 5 h 0"), HasSubstr("FLASER robot y"));
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 3 1 1e999 3 5 h 0"), HasSubstr("found '1e999'"));
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 3 1 2 3 inf h 0"), HasSubstr("FLASER timestamp"));
  const ReadLog log = read_text("FLASER 3 nan inf 1e99 1 2 3 1 2 3 5 h 0\n");
  ASSERT_EQ(log.readings.size(), 1U);
  for (const float range_m : log.readings[0].ranges_m) EXPECT_FALSE(std::isfinite(range_m));
}

TEST(MalformedLine, ALineWithoutTimestampInALogWithTimesIsNamed) {
  EXPECT_THAT(issue_of("FLASER 2 7 8 1 2 3 1 2 3"),
              HasSubstr("FLASER timestamp: expected a number, found the end of the line"));
}

TEST(MalformedLine, ControlCharactersDoNotReachTheMessage) {
  EXPECT_THAT(issue_of(std::string("ODOM 1 \x01\x02\x1b[31m 3 0 0 0 9 h 0")),
              HasSubstr("found '???[31m'"));
}

TEST(MalformedLine, OfManyTheFirstHundredAreListedAndTheRestCounted) {
  std::string text = kGood;
  for (int i = 0; i < 250; ++i) text += "ODOM x\n";
  const ReadLog log = read_text(text + kGood);
  EXPECT_EQ(log.readings.size(), 2U);
  EXPECT_EQ(log.info.malformed_lines, 250);
  EXPECT_EQ(log.info.issues_not_listed, 150);
  EXPECT_EQ(log.info.issues.size(), 101U);  // and the note on the two-beam scanner
}

TEST(MalformedLine, ALineLongerThanAMegabyteIsLeftOut) {
  const ReadLog log = read_text(kGood + "FLASER 2" + times(800'000, "1") + "\n" + kGood);
  EXPECT_EQ(log.readings.size(), 2U);
  EXPECT_EQ(log.info.malformed_lines, 1);
  EXPECT_THAT(texts(log.info.issues),
              testing::Contains(HasSubstr("mission.clf:2: the line is longer")));
}

TEST(MalformedLine, AnIncompleteLastLineMeansThatTheLogIsCutShort) {
  for (const char* last : {"FLASER 2 7", "FLASER 2 7 8 1 2 3 1", "FLASER 2 7 8 1 2 3 1 2 3",
                           "FLASER 2 7 8 1 2 3 1 2 3 5", "FLA", "F"}) {
    const ReadLog log = read_text(kGood + last);
    EXPECT_EQ(log.readings.size(), 1U) << last;
    EXPECT_EQ(log.info.malformed_lines, 0) << last;
    EXPECT_THAT(texts(log.info.issues),
                testing::Contains(StartsWith("mission.clf:2: the log is cut short")))
        << last;
  }
}

TEST(MalformedLine, AWholeLastLineNeedsNoLineEnd) {
  const ReadLog log = read_text(kGood + kGood.substr(0, kGood.size() - 1));
  EXPECT_EQ(log.readings.size(), 2U);
  EXPECT_THAT(texts(log.info.issues), ElementsAre(HasSubstr("number of readings")));
  const ReadLog comment = read_text(kGood + "# end");
  EXPECT_EQ(comment.info.issues.size(), 1U);
}

}  // namespace
}  // namespace roomatlas
