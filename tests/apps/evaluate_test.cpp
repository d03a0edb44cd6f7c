// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

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
