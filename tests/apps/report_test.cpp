// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string report_of(const Folder& folder) {
  const std::string store = assembled_store(folder);
  EXPECT_EQ(run("-q rename " + store + " 3 'Lab </script> 315'").exit_code, 0);
  const std::string file = (folder / "report.html").string();
  const Outcome written = run("-q report " + store + " -o " + file);
  EXPECT_EQ(written.exit_code, 0) << written.err;
  return file;
}

TEST(Report, IsOneFileThatNamesNothingToFetch) {
  const Folder folder;
  const std::string page = content_of(report_of(folder));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("name=\"viewport\""));
  EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(<(script|img|iframe)[^>]*\ssrc=)")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(url\((?!#))")));
  EXPECT_THAT(page, HasSubstr("Lab \\u003c/script> 315"));
}

TEST(Report, WorksInABrowserFromAFileOnADesktopAndOnAPhone) {
  ROOMATLAS_NEEDS("chromium");
  ROOMATLAS_NEEDS("node");
  const Folder folder;
  const std::string page = report_of(folder);
  for (const char* size : {"1440 1000", "390 844"}) {
    const Outcome looked = run_other("timeout 300 node " + std::string(ROOMATLAS_SOURCE_DIR) +
                                     "/tests/apps/browser/look_around.mjs " + page + " " +
                                     (folder / "profile").string() + " " + size);
    EXPECT_EQ(looked.exit_code, 0) << looked.err;
    EXPECT_EQ(looked.out,
              "row 3; highlighted 1; map 3; key 5; seen true; moved true; ellipses true; found 3; "
              "sorted true; layers rooms,walls,doors,furniture,evidence,unexplored,graph,seen,"
              "trajectory,corrections,uncertainty; wider than the window false; fetched ; "
              "complaints ")
        << size;
  }
}

TEST(Report, PrintsOnAFewPagesWithEveryRoom) {
  ROOMATLAS_NEEDS("chromium");
  ROOMATLAS_NEEDS("pdftotext");
  const Folder folder;
  const std::string report = report_of(folder);
  const std::string pdf = (folder / "report.pdf").string();
  (void)run_other("timeout 300 chromium --headless --no-sandbox --disable-gpu --user-data-dir=" +
                  (folder / "profile").string() + " --print-to-pdf=" + pdf + " file://" + report);
  const std::string text = run_other("pdftotext -layout " + pdf + " -").out;
  EXPECT_THAT(text, HasSubstr("Lab </script> 315"));
  EXPECT_THAT(text, HasSubstr("Not a survey"));
  EXPECT_LE(std::count(text.begin(), text.end(), '\f'), 8);
  // The plan is on the first page: rooms are tinted, and most of the page is white without them.
  ROOMATLAS_NEEDS("pdftoppm");
  (void)run_other("pdftoppm -r 20 -gray -l 1 -singlefile " + pdf + " " +
                  (folder / "page").string());
  const std::string grey = content_of(folder / "page.pgm");
  const auto tinted = std::count_if(grey.begin(), grey.end(), [](char value) {
    const int level = static_cast<unsigned char>(value);
    return level > 220 && level < 250;
  });
  EXPECT_GT(tinted, static_cast<std::ptrdiff_t>(grey.size() / 10));
}

TEST(Report, ATruthOfAnotherClockIsTold) {
  const Folder folder;
  const std::string store = assembled_store(folder);
  const auto truth = folder.write("truth.tum", "5 0 0 0 0 0 0 1\n6 1 0 0 0 0 0 1\n");
  const Outcome made =
      run("report " + store + " --truth " + truth.string() + " -o " + (folder / "r.html").string());
  EXPECT_EQ(made.exit_code, 0);
  EXPECT_THAT(made.err, HasSubstr("no time of the truth [5.000, 6.000] s has a pose"));
}

}  // namespace
}  // namespace roomatlas::test
