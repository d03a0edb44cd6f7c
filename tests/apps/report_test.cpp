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
  document.querySelectorAll('#layers input').forEach((box) => { if (!box.checked) box.click(); });
  report.push('layers ' + [...document.querySelectorAll('#layers input')].map((box) => box.id.slice(6)).join(','));
  report.push('ellipses ' + (document.querySelectorAll('.leaflet-missions-pane path[stroke="#00795c"]').length > 0));
  report.push('wider than the window ' + (document.documentElement.scrollWidth > window.innerWidth));
  report.push('fetched ' + performance.getEntriesByType('resource').length);
  const result = document.createElement('p');
  result.id = 'probe';
  result.textContent = report.join('; ');
  document.body.append(result);
});
</script></body>)js";

/// What the probe found in a window of that size; what the browser printed must name no console
/// message, such as an error or a request that the page's own policy forbade.
std::string probed(const Folder& folder, const std::string& page, const std::string& size) {
  std::string with_probe = page;
  with_probe.replace(with_probe.rfind("</body>"), 7, kProbe);
  const auto probe = folder.write("probe.html", with_probe);
  const Outcome shown = run_other(
      "timeout 300 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
      "--host-resolver-rules='MAP * ~NOTFOUND' --window-size=" +
      size + " --user-data-dir=" + (folder / "profile").string() +
      " --virtual-time-budget=5000 --dump-dom file://" + probe.string());
  EXPECT_THAT(shown.err, Not(HasSubstr("CONSOLE")));
  const std::string start = "<p id=\"probe\">";
  const std::size_t at = shown.out.find(start);
  if (at == std::string::npos) return "the page did not get so far: " + shown.err;
  return shown.out.substr(at + start.size(), shown.out.find('<', at + 1) - at - start.size());
}

TEST(Report, WorksInABrowserFromAFileOnADesktopAndOnAPhone) {
  ROOMATLAS_NEEDS("chromium");
  const Folder folder;
  const std::string page = content_of(report_of(folder));
  for (const char* size : {"1440,1000", "390,844"}) {
    EXPECT_EQ(probed(folder, page, size),
              "row 3; highlighted 1; map 3; key 5; moved true; found 3; sorted true; layers "
              "rooms,walls,doors,furniture,evidence,unexplored,graph,seen,trajectory,corrections,"
              "uncertainty; ellipses true; wider than the window false; fetched 0")
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
}

}  // namespace
}  // namespace roomatlas::test
