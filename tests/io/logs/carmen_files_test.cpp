// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mission_log.hpp"

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/trajectories/trajectory_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace roomatlas {
namespace {

using test::gzipped;
using test::read_log;
using test::ReadLog;
using test::TemporaryFolder;
using test::texts;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string scans(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const std::string x = std::to_string(i * 0.37);
    text += "FLASER 181" + test::times(181, x) + " " + x + " 0 0 " + x + " 0 0 " +
            std::to_string(100 + i) + " h 0\n";
  }
  return text;
}

std::string refusal(const Path& file) {
  try {
    (void)open_mission(file, {});
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.filename().string()));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

TEST(MissionFile, PlainAndGzipGiveTheSameEvents) {
  const TemporaryFolder folder;
  const ReadLog plain = read_log(folder.write("plain.clf", scans(300)));
  const ReadLog gz = read_log(folder.write("packed.dat", gzipped(folder, scans(300))));
  ASSERT_EQ(plain.readings.size(), 300U);
  ASSERT_EQ(gz.readings.size(), 300U);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(plain.readings[i].timestamp_s, gz.readings[i].timestamp_s);
    EXPECT_EQ(plain.readings[i].odom_from_robot, gz.readings[i].odom_from_robot);
    EXPECT_EQ(plain.readings[i].ranges_m, gz.readings[i].ranges_m);
  }
  EXPECT_THAT(gz.info.issues, IsEmpty());
  EXPECT_EQ(plain.info.path_length_m, gz.info.path_length_m);
}

TEST(MissionFile, GzipDataThatIsCutShortGivesWhatIsWholeAndAWarning) {
  const TemporaryFolder folder;
  const std::string packed = gzipped(folder, scans(300));
  const ReadLog log = read_log(folder.write("cut.clf.gz", packed.substr(0, packed.size() / 2)));
  EXPECT_GT(log.readings.size(), 50U);
  EXPECT_LT(log.readings.size(), 300U);
  EXPECT_EQ(log.info.malformed_lines, 0);
  ASSERT_EQ(log.info.issues.size(), 1U);
  EXPECT_EQ(log.info.issues[0].severity, Severity::warning);
  EXPECT_THAT(to_string(log.info.issues[0]), HasSubstr("the log is cut short"));
  EXPECT_THAT(to_string(log.info.issues[0]), HasSubstr("mapped up to the cut"));
}

TEST(MissionFile, GzipDataThatLacksItsChecksumOnlyIsCutShortToo) {
  const TemporaryFolder folder;
  const std::string packed = gzipped(folder, scans(30));
  const ReadLog log = read_log(folder.write("cut.clf.gz", packed.substr(0, packed.size() - 4)));
  EXPECT_EQ(log.readings.size(), 30U);
  EXPECT_THAT(texts(log.info.issues), Contains(HasSubstr("cut.clf.gz:30: the log is cut short")));
}

TEST(MissionFile, GzipDataThatIsDamagedGivesWhatCameBeforeAndAWarning) {
  const TemporaryFolder folder;
  std::string packed = gzipped(folder, scans(3000));
  for (std::size_t i = 0; i < 64; ++i) packed[packed.size() / 2 + i] = '\xFF';
  const ReadLog log = read_log(folder.write("hurt.clf.gz", packed));
  EXPECT_GT(log.readings.size(), 100U);
  EXPECT_LT(log.readings.size(), 3000U);
  EXPECT_THAT(texts(log.info.issues), Contains(HasSubstr("its gzip data is damaged")));
}

TEST(MissionFile, DamageOfGzipDataIsToldBeforeTheLinesThatItMadeWrong) {
  const TemporaryFolder folder;
  std::string packed = gzipped(folder, "ODOM x\n" + scans(3000));
  const std::string whole = packed;
  for (std::size_t i = 0; i < 64; ++i) packed[packed.size() / 2 + i] = '\xFF';
  const ReadLog hurt = read_log(folder.write("hurt.clf.gz", packed));
  EXPECT_THAT(to_string(hurt.info.issues.at(0)), HasSubstr("its gzip data is damaged"));
  EXPECT_THAT(to_string(hurt.info.issues.at(1)), HasSubstr("hurt.clf.gz:1: ODOM x"));

  packed = whole;
  packed[packed.size() - 8] ^= '\x01';  // of the checksum
  const ReadLog wrong = read_log(folder.write("wrong.clf.gz", packed));
  EXPECT_THAT(to_string(wrong.info.issues.at(0)),
              HasSubstr("any line may be wrong. Copy the file"));
}

TEST(MissionFile, MayHaveLinesThatEndWithACarriageReturnAlone) {
  const TemporaryFolder folder;
  std::string text = scans(300);
  for (char& c : text) c = c == '\n' ? '\r' : c;
  const ReadLog log = read_log(folder.write("old.clf", text));
  EXPECT_EQ(log.readings.size(), 300U);
  EXPECT_EQ(log.readings.back().timestamp_s, 399.0);
  EXPECT_THAT(log.info.issues, IsEmpty());
}

TEST(MissionFile, ThatIsAPipeIsRefusedBecauseItCanBeReadOnce) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe.clf";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal(pipe), HasSubstr("is not a regular file"));
  EXPECT_THAT(refusal(pipe), HasSubstr("save it to a file first"));
  EXPECT_THROW((void)read_trajectory(pipe, {}, LogPoses::recorded), InputError);
}

TEST(MissionFile, MayHaveANameThatIsNotUtf8) {
  const TemporaryFolder folder;
  const ReadLog log = read_log(folder.write("caf\xE9.clf", "ODOM x\n" + scans(2)));
  EXPECT_EQ(log.info.file, "caf\uFFFD.clf");
  EXPECT_THAT(to_json(log.info), HasSubstr("caf\uFFFD.clf:1: ODOM x"));
  MissionInfo info;
  info.file = "\xE9";
  EXPECT_THAT(to_json(info), HasSubstr("\uFFFD"));
}

TEST(MissionFile, ThatCannotBeALogIsRefusedWithOneLineThatNamesItAndTheReason) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "nowhere.clf"), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is a directory"));
  EXPECT_THAT(refusal(folder.write("empty.clf", "")), HasSubstr("is empty"));
  EXPECT_THAT(refusal(folder.write("empty.gz", gzipped(folder, ""))), HasSubstr("is empty"));
  EXPECT_THAT(refusal(folder.write("binary.map", std::string("ODOM 1 2 3\0\0\n", 13))),
              HasSubstr("is a binary file"));
  EXPECT_THAT(refusal(folder.write("stub.gz", gzipped(folder, scans(9)).substr(0, 12))),
              HasSubstr("cut short at the very beginning"));
  EXPECT_THAT(refusal(folder.write("comments.clf", "# CARMEN Logfile\n\n")),
              HasSubstr("holds comments only"));
}

TEST(MissionFile, OfAnotherProgramIsRefusedWithTheRemedy) {
  const TemporaryFolder folder;
  for (const std::string name : {"CSensoryFrame", "mrpt::obs::CObservationComment"}) {
    const std::string object =
        static_cast<char>(0x80 | name.size()) + name + std::string("\x02\0\0\0\x05", 5);
    for (const std::string& bytes : {object, gzipped(folder, object)}) {
      const std::string said = refusal(folder.write("a.rawlog", bytes));
      EXPECT_THAT(said, HasSubstr("is a rawlog of MRPT"));
      EXPECT_THAT(said, HasSubstr("rosbag record"));
    }
  }
  // As long as it says it is, but no class's name.
  EXPECT_THAT(refusal(folder.write("b", std::string("\x84"
                                                    "C\x01\x02\0",
                                                    5))),
              HasSubstr("is a binary file"));
  for (const std::string magic : {"#ROSBAG V2.0\n", "\x89MCAP0\r\n", "SQLite format 3"}) {
    EXPECT_THAT(refusal(folder.write("c.gz", gzipped(folder, magic + std::string(99, '\0')))),
                HasSubstr("unpack it with gunzip"));
  }
}

TEST(MissionFile, OfTextWithoutAKnownTagIsRefusedAndTheKnownTagsAreListed) {
  const TemporaryFolder folder;
  const std::string few = refusal(folder.write("fr079.relations", "1 2 0.1 0 0 0 0 0.1\n"));
  EXPECT_THAT(few, HasSubstr("is not a CARMEN log"));
  EXPECT_THAT(few, HasSubstr("ODOM, FLASER, RLASER, ROBOTLASER1"));
  std::string many;
  for (int i = 0; i < 1500; ++i) many += "Laser 1 2 3\n";
  EXPECT_THAT(refusal(folder.write("loop5.log", many + scans(1))),
              HasSubstr("is not a CARMEN log"));
}

TEST(MissionFile, MayBeginWithAByteOrderMarkAndManyComments) {
  const TemporaryFolder folder;
  std::string text = "\xEF\xBB\xBF";
  for (int i = 0; i < 3000; ++i) text += "# comment\n";
  EXPECT_EQ(read_log(folder.write("mission.clf", text + scans(2))).readings.size(), 2U);
  EXPECT_EQ(read_log(folder.write("mission.clf", "\xEF\xBB\xBF" + scans(2))).readings.size(), 2U);
}

TEST(MissionFile, ReportsItsProgressFromZeroToOne) {
  const TemporaryFolder folder;
  const auto source = open_mission(folder.write("mission.clf", scans(3000)), {});
  double last = source->progress();
  EXPECT_LT(last, 0.3);
  while (source->next()) {
    EXPECT_GE(source->progress(), last);
    last = source->progress();
    EXPECT_LE(last, 1.0);
  }
  EXPECT_EQ(source->progress(), 1.0);
}

}  // namespace
}  // namespace roomatlas
