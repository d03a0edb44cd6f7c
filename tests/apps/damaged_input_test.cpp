// SPDX-License-Identifier: GPL-3.0-or-later
// Every command on inputs that were damaged at random: a result or an error that names the file,
// never an internal error. ROOMATLAS_MUTATIONS=N tries N of them instead of a few,
// ROOMATLAS_MUTATION_SEED=S others.
#include <gmock/gmock.h>

#include <array>
#include <random>

#include "fuzz/mutate.hpp"
#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

/// A command, and the input that is damaged before: "{}" in it stands for the folder.
struct Trial {
  std::string input;
  std::string command;
};

class DamagedInput : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    store_ = assembled_store(*folder_);
    const std::string worlds = std::string(ROOMATLAS_SOURCE_DIR) + "/data/worlds/";
    std::filesystem::copy_file(worlds + "two_rooms.geojson", *folder_ / "world.geojson");
    expect_run("simulate " + worlds + "two_rooms.geojson --max-time 30 --sensor laser -o {}");
    expect_run("build {}/mission.clf -o {}/built");
    for (const char* format : {"bag", "mcap", "db3"}) {
      expect_run(std::string("convert {}/mission.clf -o {}/mission.") + format);
    }
    expect_run("export " + store_ + " -f g2o,nav2,tum -o {}/exported");
    (void)folder_->write("edits.json",
                         R"({"format":"roomatlas-edits","version":1,"frame":"building","edits":[
{"edit":"name_room","room":{"id":3,"at_m":[1.5,2.0]},"name":"Kitchen"},
{"edit":"join_rooms","rooms":[{"id":1},{"id":2}]},
{"edit":"move_wall","wall_m":[[1.0,0.0],[1.0,4.0]],"by_m":-0.2}]})");
    (void)folder_->write("settings.toml", "cell=0.1\nmax-piece=8\njobs=1\n");
    (void)folder_->write("tape.csv", "one, door 1, door 2, 3.5\n");
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string placed(std::string text) {
    const std::string folder = (*folder_ / "").string();
    for (std::size_t at; (at = text.find("{}")) != std::string::npos;) {
      text.replace(at, 2, folder.substr(0, folder.size() - 1));
    }
    return text;
  }
  static void expect_run(const std::string& command) {
    const Outcome outcome = run("-q " + placed(command));
    ASSERT_EQ(outcome.exit_code, 0) << command << outcome.err;
  }

  static inline Folder* folder_ = nullptr;
  static inline std::string store_;
};

TEST_F(DamagedInput, NeverEndsACommandWithAnInternalError) {
  const std::string x = "{}/damaged/";
  const std::vector<Trial> trials = {
      {"mission.clf", "build " + x + "mission.clf -o {}/out"},
      {"mission.clf", "info --json " + x + "mission.clf"},
      {"mission.clf", "convert " + x + "mission.clf -o {}/out.mcap"},
      {"mission.clf", "locate {}/built/building.gpkg " + x + "mission.clf"},
      {"mission.clf", "evaluate " + x + "mission.clf --truth {}/truth.tum"},
      {"mission.bag", "build " + x + "mission.bag -o {}/out"},
      {"mission.mcap", "info " + x + "mission.mcap"},
      {"mission.mcap", "build " + x + "mission.mcap -o {}/out"},
      {"mission.db3", "convert " + x + "mission.db3 -o {}/out.clf"},
      {"truth.tum", "evaluate {}/mission.clf --truth " + x + "truth.tum"},
      {"built/building.gpkg", "compare {}/built/building.gpkg " + x + "building.gpkg -o {}/out"},
      {"built/building.gpkg", "locate " + x + "building.gpkg {}/mission.clf"},
      {"built/building.gpkg", "export " + x + "building.gpkg -f svg,nav2,graphml -o {}/out"},
      {"exported/graph.g2o", "optimize " + x + "graph.g2o -o {}/out.g2o"},
      {"exported/map.yaml", "build " + x + "map.yaml -o {}/out"},
      {"exported/map.pgm", "build --resolution 0.05 " + x + "map.pgm -o {}/out"},
      {"world.geojson", "simulate " + x + "world.geojson --max-time 5 -o {}/out"},
      {"truth.geojson", "evaluate {}/built/building.gpkg --truth " + x + "truth.geojson"},
      {"tape.csv", "evaluate {}/built/building.gpkg --truth " + x + "tape.csv"},
      {"edits.json", "assemble " + store_ + " --edits " + x + "edits.json"},
      {"settings.toml", "--config " + x + "settings.toml info {}/mission.clf"},
  };
  const char* wanted = std::getenv("ROOMATLAS_MUTATIONS");
  const std::size_t count = wanted != nullptr ? std::stoul(wanted) : trials.size();
  const char* seed = std::getenv("ROOMATLAS_MUTATION_SEED");
  const std::uint64_t first = seed != nullptr ? 1'000'000 * std::stoull(seed) : 0;
  std::filesystem::create_directories(*folder_ / "damaged");
  for (std::size_t i = 0; i < count; ++i) {
    const Trial& trial = trials[i % trials.size()];
    const std::string whole = content_of(*folder_ / trial.input);
    ASSERT_NE(whole, "") << trial.input;
    fuzz::Random random(first + i + 1);
    const std::string name = std::filesystem::path(trial.input).filename().string();
    (void)folder_->write("damaged/" + name, fuzz::mutated(whole, whole, random, whole.size() * 2));
    const Outcome outcome = run("-q " + placed(trial.command));
    EXPECT_THAT(outcome.exit_code, AnyOf(0, 2, 3, 4)) << i << " " << trial.command << outcome.err;
    if (outcome.exit_code == 3) {
      EXPECT_THAT(outcome.err, HasSubstr(name)) << i << " " << trial.command;
    }
  }
}

}  // namespace
}  // namespace roomatlas::test
