// SPDX-License-Identifier: GPL-3.0-or-later
// Manual pages and completions, read by those that they are for.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "program.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

bool has(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What a shell prints that runs a script.
std::string said_by(const std::string& shell, const Folder& folder, const std::string& script) {
  const std::string file = folder.write("script", script).string();
  (void)std::system((shell + " " + file + " >" + (folder / "said").string() + " 2>&1").c_str());
  return content_of(folder / "said");
}

std::string completion_for(const std::string& shell, const Folder& folder) {
  const Outcome written = run("completion " + shell);
  EXPECT_EQ(written.exit_code, 0) << written.err;
  return folder.write("completion." + shell, written.out).string();
}

/// Words that bash would offer at the end of a line.
std::string bash_offers(const Folder& folder, const std::string& words) {
  return said_by(
      "bash", folder,
      "source " + completion_for("bash", folder) + "\nCOMP_WORDS=(" + words +
          ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_roomatlas\necho ${COMPREPLY[*]}\n");
}

TEST(Completion, OfBashOffersWhatFits) {
  const Folder folder;
  EXPECT_EQ(bash_offers(folder, "roomatlas b"), "build\n");
  EXPECT_EQ(bash_offers(folder, "roomatlas build --str"), "--strict\n");
  EXPECT_EQ(bash_offers(folder, "roomatlas --json build x --model ''"), "rotation se2\n");
  EXPECT_EQ(bash_offers(folder, "roomatlas evaluate a --match n"), "nearest\n");
  EXPECT_EQ(bash_offers(folder, "roomatlas completion ''"), "bash zsh fish\n");
  EXPECT_EQ(bash_offers(folder, "roomatlas rename --ce"), "\n");              // does not map
  EXPECT_EQ(bash_offers(folder, "roomatlas simulate w --furnish ''"), "\n");  // any number
  folder.write("a map.yaml", "");
  std::filesystem::create_directory(folder / "a folder");
  const std::string start = (folder / "a").string();
  EXPECT_THAT(bash_offers(folder, "roomatlas build " + start),
              AllOf(HasSubstr("a map.yaml"), HasSubstr("a folder")));
  EXPECT_THAT(bash_offers(folder, "roomatlas build x -o " + start),
              AllOf(Not(HasSubstr("a map.yaml")), HasSubstr("a folder")));
}

TEST(Completion, OfFishOffersWhatFits) {
  if (!has("fish")) GTEST_SKIP() << "no fish";
  const Folder folder;
  const std::string source = "source " + completion_for("fish", folder) + "\n";
  const auto offers = [&](const std::string& line) {
    return said_by("HOME=" + (folder / "home").string() + " fish --no-config", folder,
                   source + "complete -C '" + line + "'\n");
  };
  EXPECT_THAT(offers("roomatlas b"), AllOf(HasSubstr("build\t"), Not(HasSubstr("map\t"))));
  EXPECT_THAT(offers("roomatlas build --str"), HasSubstr("--strict\t"));
  EXPECT_THAT(offers("roomatlas build --model "), AllOf(HasSubstr("rotation"), HasSubstr("se2")));
  EXPECT_THAT(offers("roomatlas rename --ce"), IsEmpty());
}

TEST(Completion, OfZshIsSoundAndKnownToIt) {
  if (!has("zsh")) GTEST_SKIP() << "no zsh";
  const Folder folder;
  const std::string file = completion_for("zsh", folder);
  EXPECT_THAT(said_by("zsh -f -n " + file + " #", folder, ""), IsEmpty());
  // the program's own completion system takes it, and keeps every specification that it is given
  const std::string said =
      said_by("zsh -f", folder,
              "autoload -Uz compinit; compinit -u -D\n"
              "source " +
                  file +
                  "\n"
                  "_arguments() { print -l -- \"$@\"; state=argument; line=(build) }\n"
                  "print ${_comps[roomatlas]}\n"
                  "_roomatlas\n");
  EXPECT_THAT(said, AllOf(HasSubstr("_roomatlas\n"), HasSubstr("--strict[")));
}

TEST(Completion, ForAnotherShellIsRefused) {
  const Outcome outcome = run("completion tcsh");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("expected one of bash, zsh, fish, found \"tcsh\""));
}

/// What the checkers that are there find in a page.
void expect_sound(const std::string& page, const Folder& folder) {
  EXPECT_THAT(content_of(page), HasSubstr(".SH NAME\n")) << page;
  if (has("mandoc")) {
    const std::string said =
        said_by("sh", folder, "mandoc -Tlint -W warning " + page + " | grep -v 'missing date'\n");
    EXPECT_EQ(said, "");
  }
  if (has("groff")) {
    EXPECT_EQ(said_by("sh", folder, "groff -man -ww -z " + page + "\n"), "");
  }
}

TEST(ManualPages, AreOneForTheProgramAndOneForEachCommand) {
  const Folder folder;
  ASSERT_EQ(run("man -o " + (folder / "man").string()).exit_code, 0);
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "man")) {
    ++pages;
    expect_sound(entry.path().string(), folder);
  }
  EXPECT_GE(pages, 18);
  EXPECT_EQ(run("man").out, content_of(folder / "man" / "roomatlas.1"));
  EXPECT_EQ(run("man build").out, content_of(folder / "man" / "roomatlas-build.1"));
}

#ifdef ROOMATLAS_FLEET
TEST(ManualPages, AreOneForTheFleetWithItsParameters) {
  const Folder folder;
  const std::string page = (folder / "roomatlas-fleet.1").string();
  (void)said_by("sh", folder, std::string(ROOMATLAS_FLEET) + " --man > " + page + "\n");
  expect_sound(page, folder);
  EXPECT_THAT(content_of(page), HasSubstr("\\fB\\-\\-output\\fR"));
  EXPECT_THAT(content_of(page), HasSubstr("\\fB\\-\\-jobs\\fR"));
}
#endif

TEST(ManualPages, SayWhatTheHelpSays) {
  const std::string page = run("man build").out;
  EXPECT_THAT(page, AllOf(HasSubstr("\\-\\-strict"), HasSubstr("\\-\\-cell"),
                          HasSubstr("From 0.02 to 1."), HasSubstr(".SH EXIT STATUS")));
  EXPECT_THAT(page, Not(HasSubstr("explore\\-on")));
}

}  // namespace
}  // namespace roomatlas::test
