// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace roomatlas::test {
namespace {

/// A square that is driven round twice; the corners of the second round are those of the first.
std::string two_rounds(const std::string& more = "") {
  std::string text;
  const std::string information = " 100 0 0 100 0 400\n";
  for (int i = 0; i < 8; ++i) {
    text += "EDGE_SE2 " + std::to_string(i) + " " + std::to_string(i + 1) + " 4 0.01 1.5708" +
            information;
  }
  for (int i = 0; i < 5; ++i) {
    text +=
        "EDGE_SE2 " + std::to_string(i) + " " + std::to_string(i + 4) + " 0.01 0 0" + information;
  }
  return text + more;
}

const char* kFalseLoop = "EDGE_SE2 0 6 0 0 0 100 0 0 100 0 400\n";

struct Solving {
  Outcome outcome;
  bool wrote = false;
};

Solving optimize(const std::string& graph, const std::string& options = "") {
  const Folder folder;
  const auto in = folder.write("in.g2o", graph);
  const auto out = folder / "out.g2o";
  Solving result;
  result.outcome = run("optimize " + in.string() + " -o " + out.string() + " " + options);
  result.wrote = std::filesystem::exists(out);
  return result;
}

TEST(OptimizeCommand, WritesTheGraphAndLeavesStderrClean) {
  for (const char* solver : {"block", "ceres"}) {
    const Solving result = optimize(two_rounds(), std::string("--solver ") + solver);
    EXPECT_EQ(result.outcome.exit_code, 0);
    EXPECT_EQ(result.outcome.err, "");
    EXPECT_TRUE(result.wrote);
    EXPECT_NE(result.outcome.out.find("chi-square"), std::string::npos);
  }
}

TEST(OptimizeCommand, PrintsOneJsonObject) {
  const Solving result = optimize(two_rounds(), "--json");
  const auto json = nlohmann::json::parse(result.outcome.out);
  EXPECT_EQ(json.at("nodes"), 9);
  EXPECT_EQ(json.at("loops"), 5);
  EXPECT_TRUE(json.at("trusted").get<bool>());
  EXPECT_GT(json.at("iterations").get<int>(), 0);
  EXPECT_GE(json.at("seconds").get<double>(), 0.0);
  EXPECT_LT(json.at("chi_square").get<double>(), json.at("initial_chi_square").get<double>());
  EXPECT_EQ(json.at("closures").size(), 5U);
}

TEST(OptimizeCommand, RejectsAFalseLoopWhenAskedTo) {
  const Solving result = optimize(two_rounds(kFalseLoop), "--robust --json");
  const auto json = nlohmann::json::parse(result.outcome.out);
  EXPECT_EQ(json.at("rejected"), 1);
  EXPECT_FALSE(json.at("closures").back().at("accepted").get<bool>());
  EXPECT_NE(json.at("closures").back().at("reason").get<std::string>().find("contradicts"),
            std::string::npos);
}

TEST(OptimizeCommand, StrictTurnsADoubtfulResultIntoExitCode5) {
  const Solving plain = optimize(two_rounds(kFalseLoop));
  EXPECT_EQ(plain.outcome.exit_code, 0);
  EXPECT_NE(plain.outcome.err.find("--robust"), std::string::npos);
  const Solving strict = optimize(two_rounds(kFalseLoop), "--strict");
  EXPECT_EQ(strict.outcome.exit_code, 5);
  EXPECT_TRUE(strict.wrote);
  EXPECT_EQ(optimize(two_rounds(), "--strict").outcome.exit_code, 0);
}

TEST(OptimizeCommand, WrongGraphsHaveTheirExitCodes) {
  const std::string edge = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";
  const struct {
    std::string graph;
    int exit_code;
    std::string mentions;
  } cases[] = {
      {edge + "EDGE_SE2 1 2 nan 0 0 1 0 0 1 0 1\n", 3, "in.g2o:2"},
      {edge + "EDGE_SE2 1 2 1 0 0 -1 0 0 1 0 1\n", 3, "in.g2o:2"},
      {"VERTEX_SE2 0 0 0 0\nVERTEX_SE2 0 0 0 0\n" + edge, 3, "in.g2o:2"},
      {"VERTEX_SE2 0 0 0 0\n" + edge, 3, "in.g2o:2"},
      {"VERTEX_SE2 0 0 0 0\n", 4, "no edge"},
      {"VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 0 0 0\n", 4, "no edge"},
      {"", 3, "empty"},
  };
  for (const auto& wrong : cases) {
    const Solving result = optimize(wrong.graph);
    EXPECT_EQ(result.outcome.exit_code, wrong.exit_code) << wrong.graph << result.outcome.err;
    EXPECT_EQ(result.outcome.err.rfind("error: ", 0), 0U) << result.outcome.err;
    EXPECT_NE(result.outcome.err.find(wrong.mentions), std::string::npos) << result.outcome.err;
    EXPECT_FALSE(result.wrote);
  }
}

TEST(OptimizeCommand, NumbersThatAreNoneAreNotWritten) {
  const Folder folder;
  const std::string out = (folder / "out.g2o").string();
  for (const char* numbers : {"1e200 0 0 1 0 0 1 0 1", "1 1e190 0 1 0 0 1 0 1"}) {
    const std::string edge = std::string("EDGE_SE2 0 1 ") + numbers + "\n";
    const auto graph = folder.write(
        "in.g2o", edge + "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 2 5 0 0 1 0 0 1 0 1\n");
    const Outcome outcome = run("-q optimize " + graph.string() + " -o " + out);
    EXPECT_EQ(outcome.exit_code, 4) << numbers;
    EXPECT_THAT(outcome.err, ::testing::HasSubstr("the edge from 0 to 1")) << numbers;
    EXPECT_FALSE(std::filesystem::exists(out)) << numbers;
  }
}

TEST(OptimizeCommand, TwoComponentsAreBothSolved) {
  const Solving result = optimize(two_rounds("EDGE_SE2 50 51 1 0 0 1 0 0 1 0 1\n"), "--json");
  EXPECT_EQ(nlohmann::json::parse(result.outcome.out).at("components"), 2);
}

TEST(OptimizeCommand, CovariancesGoToATable) {
  const Folder folder;
  const auto in = folder.write("in.g2o", two_rounds());
  const Outcome outcome = run("optimize " + in.string() + " -o " + (folder / "o.g2o").string() +
                              " --covariance " + (folder / "c.csv").string());
  EXPECT_EQ(outcome.exit_code, 0);
  const std::string table = content_of(folder / "c.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 9 + 13);
  EXPECT_EQ(table.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace roomatlas::test
