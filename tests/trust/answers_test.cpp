// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/plan/answers.hpp"

#include <gtest/gtest.h>

#include "roomatlas/io/results/summary.hpp"

namespace roomatlas {
namespace {

TEST(Answers, OfOneNothingIsSaid) { EXPECT_EQ(words(Answers{}), ""); }

TEST(Answers, TheFirstTellsOfTheSecondAndTheSecondWhichItIs) {
  Answers answers{1, 2, 420.2, 411.6, "turned by 90 deg"};
  EXPECT_EQ(words(answers),
            "a second answer explains the readings nearly as well (412 m of wall speak for it "
            "against 420 m): turned by 90 deg");
  answers.drawn = 2;
  EXPECT_EQ(words(answers),
            "this is alternative 2 of 2 (412 m of wall speak for it, 420 m for the first): "
            "turned by 90 deg");
}

TEST(Answers, StandInTheSummary) {
  const std::string answers = to_json(Answers{2, 2, 420.0, 412.0, "turned by 90 deg"});
  const Placement other = {{1, {0.1, -2.0, 3.0}}, {7, {1e-9, 4.0, -0.5}}};
  EXPECT_EQ(other_answer_in({{"other_answer_json", to_json(other)}}), other);
  EXPECT_TRUE(other_answer_in({{"other_answer_json", ""}}).empty());
  for (const char* damaged : {R"({"visits":[[1, 2]]})", "{", "[]", "{}",
                              R"({"visits":[["a", 0, 0, 0]]})", R"({"visits":[[1, 1e9, 0, 0]]})"}) {
    EXPECT_THROW((void)other_answer_in({{"other_answer_json", damaged}}), InputError) << damaged;
  }
  const std::string summary = summary_json({{"answers_json", answers}}, {}, {}, {}, std::nullopt);
  EXPECT_NE(summary.find("\"drawn\": 2"), std::string::npos);
  EXPECT_EQ(summary_json({{"answers_json", ""}}, {}, {}, {}, std::nullopt).find("\"drawn\""),
            std::string::npos);
}

}  // namespace
}  // namespace roomatlas
