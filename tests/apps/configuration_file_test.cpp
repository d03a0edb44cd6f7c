// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers on the command line and in the file of `--config`.
#include <gmock/gmock.h>

#include <algorithm>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What is said of a configuration file of this content.
std::string complaint(const std::string& content) {
  const Folder folder;
  const Outcome outcome =
      run("--config " + folder.write("my.toml", content).string() + " config --print");
  EXPECT_EQ(outcome.exit_code, 2) << content;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("roomatlas config --print"));
  return outcome.err;
}

TEST(ConfigurationFile, ThatIsWrongIsNamedWithLineAndReason) {
  EXPECT_THAT(complaint("cell 0.1\n"),
              HasSubstr("my.toml:1: expected name = value, found \"cell 0.1\""));
  EXPECT_THAT(complaint("# mine\n\nfoo = 1\n"), HasSubstr("my.toml:3: no such parameter: foo"));
  EXPECT_THAT(complaint("cell = 0.1\n[section]\n"),
              HasSubstr("my.toml:2: sections are not used: [section]"));
  EXPECT_THAT(complaint("cell = 7\n"), HasSubstr("my.toml:1: --cell: Value 7 not in range"));
  EXPECT_THAT(complaint("tau = 2\nmodel = \"se3\"\n"), HasSubstr("my.toml:2: --model"));
  EXPECT_THAT(complaint("cell = 0.1\ntau = 2\ncell = 0.2\n"),
              HasSubstr("my.toml:3: cell is given twice"));
  EXPECT_THAT(complaint("odom-topic=[\"\n"),
              HasSubstr("my.toml:1: odom-topic: expected a value after ="));
  EXPECT_THAT(complaint("max-piece=[160\ncell=0.1\n"),
              HasSubstr("my.toml:1: max-piece: expected a value after =, found a list without"));
  EXPECT_THAT(complaint("scan-topic=\",\n"),
              HasSubstr("my.toml:1: scan-topic: expected a value after ="));
  EXPECT_THAT(complaint("json = true\n"), HasSubstr("no such parameter: json"));
  for (const char* line : {"=", "= 5", "x", "x="}) (void)complaint(line);
}

TEST(ConfigurationFile, ThatIsNoTextIsRefused) {
  for (const std::string& content : {std::string("\xff\xfe"),
                                     std::string("\xff\xfe"
                                                 "c\0=\0",
                                                 6),
                                     std::string(8, '\0'),
                                     std::string("\x7f"
                                                 "ELF\1\2=1")}) {
    EXPECT_THAT(complaint(content), HasSubstr("my.toml:1: is no text of parameters"));
  }
}

TEST(ConfigurationFile, MayHaveAByteOrderMarkQuotesCommentsAndWindowsLines) {
  const Folder folder;
  const std::string file = folder.write("my.toml",
                                        "\xef\xbb\xbf"
                                        "cell = 0.1\r\n# gr\xc3\xb6\xc3\x9f"
                                        "er\r\n\"tau\" = 3 # cells\r\n");
  const Outcome outcome = run("--config " + file + " config --print");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("cell=0.1\n"), HasSubstr("tau=3\n")));
}

TEST(Numbers, ThatAreNoneAreOutOfEveryRange) {
  for (const char* name : {"sonar-cone", "tau", "max-piece", "cell", "png-dpi"}) {
    const Outcome outcome = run(std::string("--") + name + " nan config --print");
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr(std::string("--") + name + ": Value nan not in range "));
    EXPECT_THAT(complaint(std::string(name) + " = nan\n"), HasSubstr("Value nan not in range"));
  }
}

TEST(Numbers, OfSingleCommandsAreNumbersToo) {
  for (const char* arguments :
       {"export S -o D --north nan", "simulate W -o D --resolution nan",
        "simulate W -o D --start 0,nan,0", "evaluate S --time-offset nan",
        "evaluate S --max-gap nan", "evaluate S --pose-offset 0,inf,0",
        "evaluate S --split-seconds nan", "evaluate S --delta nan", "evaluate S --delta-tol nan"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("Value ")) << arguments;
  }
}

TEST(Numbers, OfSeedsAreNotNegative) {
  for (const char* arguments : {"--seed -1 config --print", "--as-sonar-seed -1 config --print",
                                "evaluate S --bootstrap-seed -1"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("Value -1 not in range 0 to ")) << arguments;
  }
}

}  // namespace
}  // namespace roomatlas::test
