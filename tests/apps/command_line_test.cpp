// SPDX-License-Identifier: GPL-3.0-or-later
// What a command line answers to somebody who does not know it: help, mistakes, quiet.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "did_you_mean.hpp"
#include "program.hpp"
#include "progress_text.hpp"
#include "roomatlas/core/counted.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t widest(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& line : lines) width = std::max(width, line.size());
  return width;
}

/// The commands that the help lists: words of lines that begin with two blanks and a letter, up to
/// the options.
std::vector<std::string> listed_commands() {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(run("--help").out)) {
    if (line.starts_with("Options")) break;
    if (!line.starts_with("  ") || line[2] == ' ') continue;
    names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

TEST(Help, OfEveryCommandFitsATerminal) {
  const std::vector<std::string> commands = listed_commands();
  EXPECT_GE(commands.size(), 16U);
  for (const std::string& command : commands) {
    const std::vector<std::string> page = lines_of(run(command + " --help").out);
    EXPECT_LE(page.size(), 40U) << command;
    EXPECT_LE(widest(page), 80U) << command;
    EXPECT_LE(widest(lines_of(run(command + " --help-all").out)), 80U) << command;
  }
  EXPECT_LE(lines_of(run("--help").out).size(), 40U);
  EXPECT_LE(widest(lines_of(run("--help-all").out)), 80U);
}

TEST(Help, ShowsEachCommandItsOwnOptionsAndTheRestWhenAsked) {
  const std::string page = run("build --help").out;
  EXPECT_THAT(page, AllOf(HasSubstr("--strict"), HasSubstr("--output FOLDER")));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("--cell")), Not(HasSubstr("--random-world"))));
  const std::string all = run("build --help-all").out;
  EXPECT_THAT(all, AllOf(HasSubstr("--cell"), HasSubstr("--match"), HasSubstr("--plan")));
  EXPECT_THAT(all, Not(HasSubstr("--explore-on")));  // of the simulator
  EXPECT_THAT(run("rename --help-all").out, Not(HasSubstr("--cell")));
  // parameters of all stages: as many as the configuration has, and those that no file may hold
  const std::string program = run("--help-all").out;
  for (const std::string& line : lines_of(run("config --print").out)) {
    if (line.empty() || line.front() == '#' || line.find('=') == std::string::npos) continue;
    EXPECT_THAT(program, HasSubstr("--" + line.substr(0, line.find('=')))) << line;
  }
}

struct Mistake {
  const char* typed;
  const char* answer;
};

TEST(Mistakes, AreAnsweredWithWhatWasMeant) {
  const Mistake mistakes[] = {
      {"bild x", "no command \"bild\"; did you mean build?"},
      {"expotr x", "did you mean export?"},
      {"build x --outptu y", "`build` has no option --outptu; did you mean --output?"},
      {"build x -o y --modle se2", "did you mean --model?"},
      {"build x -o y --door_min_widht 1", "did you mean --door-min-width?"},
      {"--verison", "did you mean --version?"},
      {"simulate w -o s --strict", "`simulate` has no option --strict: it belongs to `build`"},
      {"build x -o y --model se3",
       "expected one of rotation, se2, found \"se3\"; did you mean se2?"},
      {"evaluate a --match exct", "did you mean exact?"},
      {"map a b -o c", "`map` does not know what to do with \"b\""},
      {"build x", "usage: roomatlas build [OPTIONS] LOG|MAP... -o FOLDER"},
      {"man bild", "did you mean build?"},
      {"zzzzzz", "no command \"zzzzzz\"\n"},
  };
  for (const Mistake& mistake : mistakes) {
    const Outcome outcome = run(mistake.typed);
    EXPECT_EQ(outcome.exit_code, 2) << mistake.typed;
    EXPECT_THAT(outcome.out, IsEmpty()) << mistake.typed;
    EXPECT_THAT(outcome.err, HasSubstr(mistake.answer)) << mistake.typed;
  }
}

TEST(Mistakes, OfTheShortestKind) {
  const Outcome nothing = run("");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("Usage: roomatlas COMMAND"));
  const Outcome file = run(kTwoRooms);  // a file in the place of a command
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_THAT(file.err, HasSubstr("is no command but a file: `roomatlas build "));
}

TEST(Mistakes, InKeysOfTheConfigurationAreAnsweredToo) {
  const Folder folder;
  const std::string file = folder.write("my.toml", "tua = 2\n").string();
  EXPECT_THAT(run("--config " + file + " config --print").err,
              HasSubstr("no such parameter: tua; did you mean tau?"));
}

TEST(DidYouMean, FindsTheNearestAndNothingFarAway) {
  using apps::nearest;
  EXPECT_THAT(nearest("maap", {"map", "man", "info"}), ElementsAre("map"));
  EXPECT_THAT(nearest("ampping", {"mapping"}), ElementsAre("mapping"));          // swapped
  EXPECT_THAT(nearest("--CELL_size", {"cell-size"}), ElementsAre("cell-size"));  // spelt otherwise
  EXPECT_THAT(nearest("conf", {"config", "confuse"}), ElementsAre("config", "confuse"));
  EXPECT_THAT(nearest("tcsh", {"bash", "zsh", "fish"}), IsEmpty());
  EXPECT_THAT(nearest("", {"a"}), IsEmpty());
  EXPECT_THAT(nearest(std::string(100000, 'x'), {"xx"}), IsEmpty());
}

TEST(Counted, HasTheRightPlural) {
  EXPECT_EQ(counted(1, "room") + ", " + counted(2, "door"), "1 room, 2 doors");
  EXPECT_EQ(counted(0U, "body", "bodies"), "0 bodies");
  EXPECT_EQ(counted(1L, "body", "bodies"), "1 body");
}

TEST(ProgressText, TellsTheTimeLeftFromASecondOn) {
  using apps::progress_text;
  EXPECT_EQ(progress_text("map", 0.25, 0.5), "map 25 %");
  EXPECT_EQ(progress_text("map", 0.25, 10.0), "map 25 %, 30 s left");
  EXPECT_EQ(progress_text("map", 0.5, 200.0), "map 50 %, 3 min 20 s left");
  EXPECT_EQ(progress_text("map", 0.001, 10.0), "map 0 %");
  EXPECT_EQ(progress_text("judge", -1.0, 0.2), "judge");
  EXPECT_EQ(progress_text("judge", -1.0, 7500.0), "judge for 2 h 5 min");
  EXPECT_EQ(progress_text("map", 1.5, 10.0), "map 100 %, 0 s left");
}

TEST(Quiet, SaysNothingButErrors) {
  const Folder folder;
  const std::string out = (folder / "s").string();
  const Outcome made = run("-q simulate " + kTwoRooms + " --sensor laser -o " + out);
  EXPECT_EQ(made.exit_code, 0);
  EXPECT_EQ(made.out + made.err, "");
  const std::string log = out + "/mission.clf";
  for (const std::string& command :
       {"build " + log + " -o " + out, "export " + out + "/building.gpkg -o " + out,
        "evaluate " + out + "/building.gpkg", "info " + log,
        "inspect " + out + "/building.gpkg 1 -o " + out}) {
    const Outcome outcome = run("-q " + command);
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_EQ(outcome.out + outcome.err, "") << command;
  }
  EXPECT_THAT(run("-q info " + out + "/nothing").err, HasSubstr("error: "));
  EXPECT_THAT(run("-q --json info " + log).out, HasSubstr("\"readings\""));
}

}  // namespace
}  // namespace roomatlas::test
