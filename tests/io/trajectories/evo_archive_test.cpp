// SPDX-License-Identifier: GPL-3.0-or-later
// Archives are read by a reader of the test's own, from the formats' definitions.
#include "roomatlas/io/trajectories/evo_archive.hpp"
#include "roomatlas/io/results/comparison_text.hpp"
#include "roomatlas/io/trajectories/tum.hpp"

#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

namespace roomatlas {
namespace {

using ::testing::HasSubstr;
using Files = std::map<std::string, std::string>;

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) {
    value |= static_cast<std::uint32_t>(
                 static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i))))
             << (8 * i);
  }
  return value;
}

/// By the directory at the end, as every reader does; checks sums and that nothing is compressed.
Files unzipped(const std::string& zip) {
  Files files;
  const std::size_t end = zip.size() - 22;
  EXPECT_EQ(number_at(zip, end, 4), 0x06054b50U);
  std::size_t entry = number_at(zip, end + 16, 4);
  for (std::uint32_t i = 0; i < number_at(zip, end + 10, 2); ++i) {
    EXPECT_EQ(number_at(zip, entry, 4), 0x02014b50U);
    EXPECT_EQ(number_at(zip, entry + 10, 2), 0U);
    const std::size_t name_size = number_at(zip, entry + 28, 2);
    const std::string name = zip.substr(entry + 46, name_size);
    const std::size_t file = number_at(zip, entry + 42, 4);
    EXPECT_EQ(number_at(zip, file, 4), 0x04034b50U);
    EXPECT_EQ(zip.substr(file + 30, name_size), name);
    const std::string content = zip.substr(file + 30 + name_size, number_at(zip, entry + 24, 4));
    EXPECT_EQ(
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())),
        number_at(zip, entry + 16, 4));
    files[name] = content;
    entry += 46 + name_size;
  }
  EXPECT_EQ(entry, end);
  return files;
}

/// Doubles of a .npy file; its shape is checked against what is expected.
std::vector<double> array_in(const std::string& npy, const std::string& shape) {
  EXPECT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header = number_at(npy, 8, 2);
  EXPECT_EQ((10 + header) % 64, 0U);
  EXPECT_EQ(npy[10 + header - 1], '\n');
  EXPECT_THAT(npy.substr(10, header),
              HasSubstr("'descr': '<f8', 'fortran_order': False, 'shape': " + shape));
  std::vector<double> values((npy.size() - 10 - header) / 8);
  std::memcpy(values.data(), npy.data() + 10 + header, values.size() * 8);
  return values;
}

Comparison two_runs() {
  Trajectory truth;
  Trajectory run;
  for (int i = 0; i < 30; ++i) {
    truth.push_back({10.0 + i, {0.5 * i, 0.1 * i * i, 0.05 * i}});
    run.push_back({10.0 + i, {0.5 * i + 0.1 * std::sin(i), 0.1 * i * i + 3.0, 0.05 * i + 0.01}});
  }
  const std::vector<Relation> relations = {{10.0, 15.0, inverse(truth[0].pose) * truth[5].pose},
                                           {12.0, 39.0, inverse(truth[2].pose) * truth[29].pose}};
  return compare({{"a/b_1,\"x\"", run}, {"truth", truth}}, {"truth", relations, truth}, {});
}

TEST(EvoArchive, OfAPEHoldsWhatEvoReads) {
  const Comparison comparison = two_runs();
  const Files files = unzipped(evo_archive(evo_ape(comparison.runs[0], comparison)));
  const auto info = nlohmann::json::parse(files.at("info.json"));
  EXPECT_EQ(info["title"], "APE w.r.t. translation part (m)\n(with SE(2) Umeyama alignment)");
  EXPECT_EQ(info["label"], "APE (m)");
  EXPECT_EQ(info["est_name"], "a_b_1,\"x\"");
  const std::vector<double> errors = array_in(files.at("error_array.npy"), "(30,)");
  const JudgedPoses& judged = *comparison.runs[0].true_poses;
  EXPECT_EQ(errors, judged.ape.errors);
  const auto stats = nlohmann::json::parse(files.at("stats.json"));
  EXPECT_EQ(stats.size(), 7U);
  EXPECT_DOUBLE_EQ(stats["rmse"], judged.ape.statistics.rmse);
  EXPECT_DOUBLE_EQ(stats["std"], judged.ape.statistics.standard_deviation);
  EXPECT_EQ(array_in(files.at("timestamps.npy"), "(30,)")[3], 13.0);
  EXPECT_EQ(array_in(files.at("seconds_from_start.npy"), "(30,)")[3], 3.0);
  EXPECT_EQ(array_in(files.at("distances.npy"), "(30,)")[0], 0.0);
  EXPECT_EQ(array_in(files.at("alignment_transformation_sim3.npy"), "(4, 4)")[15], 1.0);

  const test::TemporaryFolder folder;
  const Trajectory aligned = read_tum(folder.write("est.tum", files.at("a_b_1,\"x\".tum")));
  const Trajectory truth = read_tum(folder.write("ref.tum", files.at("truth.tum")));
  ASSERT_EQ(aligned.size(), 30U);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_NEAR((aligned[i].pose.position() - truth[i].pose.position()).norm(), errors[i], 1e-9);
  }
}

TEST(EvoArchive, OfRPEHasAValueForEachPairAndOnePoseMore) {
  const Comparison comparison = two_runs();
  const EvoResult result = evo_rpe(comparison.runs[0], comparison);
  const Files files = unzipped(evo_archive(result));
  EXPECT_EQ(array_in(files.at("error_array.npy"), "(29,)").size(), 29U);
  EXPECT_EQ(array_in(files.at("timestamps.npy"), "(29,)")[0], 11.0);
  EXPECT_EQ(result.trajectories[1].second.size(), 30U);
  EXPECT_FALSE(files.contains("alignment_transformation_sim3.npy"));
}

TEST(EvoArchive, NamesTwoTrajectoriesOfOneNameApart) {
  const Comparison comparison = two_runs();
  const EvoResult result = evo_ape(comparison.runs[1], comparison);
  EXPECT_EQ(result.est_name, "truth");
  EXPECT_EQ(result.ref_name, "truth_truth");
}

TEST(EvoArchive, OfTheSameResultHasTheSameBytes) {
  const Comparison comparison = two_runs();
  EXPECT_EQ(evo_archive(evo_relations(comparison.runs[0], comparison)),
            evo_archive(evo_relations(two_runs().runs[0], comparison)));
}

TEST(ComparisonCsv, HasALineForEachFigureAndQuotesNames) {
  const std::string csv = to_csv(two_runs());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
            1 + 2 * (2 + 2 + 1 + 1)  // all, local, APE, RPE; no loop
  );
  EXPECT_THAT(csv, HasSubstr("\r\n\"a/b_1,\"\"x\"\"\",relations,all,translation,m,2,2,2,"));
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  for (std::getline(lines, line); std::getline(lines, line);) {
    if (line.starts_with("truth")) {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    }
  }
}

TEST(ComparisonLatex, EscapesNamesAndHasARowForEachRun) {
  const std::string latex = to_latex(two_runs());
  EXPECT_THAT(latex, HasSubstr("a/b\\_1,\"x\" & "));
  EXPECT_THAT(latex, HasSubstr("\\begin{tabular}{lrrrr}"));
  EXPECT_THAT(latex, HasSubstr("run & translation (m) & rotation (deg) & APE (m) & RPE (m) \\\\"));
}

TEST(ComparisonJson, HoldsAllFiguresAndWhatWasUsed) {
  const auto json = nlohmann::json::parse(to_json(two_runs()));
  EXPECT_EQ(json["used"]["match"], "exact");
  EXPECT_EQ(json["relations"], 2);
  ASSERT_EQ(json["runs"].size(), 2U);
  const auto& figures = json["runs"][0]["figures"];
  EXPECT_EQ(figures[0]["metric"], "relations");
  EXPECT_EQ(figures.back()["metric"], "rpe");
  EXPECT_TRUE(json["runs"][1]["figures"][0].contains("less_first"));
  EXPECT_FALSE(figures[0].contains("less_first"));
}

}  // namespace
}  // namespace roomatlas
