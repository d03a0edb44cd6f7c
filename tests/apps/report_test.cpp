// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

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

/// Clicks through the page once it has been loaded and writes what came of it into the page.
constexpr const char* kProbe = R"js(<script>
window.addEventListener('load', () => {
  const report = [];
  const rows = () => [...document.querySelectorAll('#rooms tbody tr')];
  const selected = () => rows().filter((row) => row.classList.contains('selected')).map((row) => row.dataset.room).join();
  rows()[2].click();
  report.push('row ' + selected());
  const highlighted = [...document.querySelectorAll('.leaflet-plan-pane path')].filter((path) => path.getAttribute('stroke-width') === '4');
  report.push('highlighted ' + highlighted.length);
  rows()[0].click();
  highlighted[0].dispatchEvent(new MouseEvent('click', { bubbles: true }));
  report.push('map ' + selected());
  rows()[4].dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));
  report.push('key ' + selected());
  const slider = document.getElementById('moment');
  const walls = () => document.querySelector('.leaflet-missions-pane path').getAttribute('d');
  document.getElementById('layer-seen').click();
  const after = walls();
  slider.value = 0;
  slider.dispatchEvent(new Event('input'));
  report.push('moved ' + (walls() !== after));
  const search = document.getElementById('search');
  search.value = 'lab 315';
  search.dispatchEvent(new Event('input'));
  report.push('found ' + rows().filter((row) => !row.hidden).map((row) => row.dataset.room).join());
  document.querySelectorAll('#rooms th button')[3].click();
  const areas = rows().map((row) => Number(row.cells[3].textContent));
  report.push('sorted ' + areas.every((area, i) => i === 0 || areas[i - 1] <= area));
  report.push('fetched ' + performance.getEntriesByType('resource').length);
  const result = document.createElement('p');
  result.id = 'probe';
  result.textContent = report.join('; ');
  document.body.append(result);
});
</script></body>)js";

TEST(Report, WorksInABrowserFromAFile) {
  if (!is_installed("chromium")) GTEST_SKIP() << "chromium is missing: the page is not tried";
  const Folder folder;
  std::string page = content_of(report_of(folder));
  page.replace(page.rfind("</body>"), 7, kProbe);
  const auto probe = folder.write("probe.html", page);
  const Outcome shown = run_other(
      "chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir=" +
      (folder / "profile").string() + " --virtual-time-budget=5000 --dump-dom file://" +
      probe.string());
  EXPECT_THAT(shown.err, Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(shown.out,
              HasSubstr("<p id=\"probe\">row 3; highlighted 1; map 3; key 5; moved true; "
                        "found 3; sorted true; fetched 0</p>"));
}

}  // namespace
}  // namespace roomatlas::test
