// SPDX-License-Identifier: GPL-3.0-or-later
// What a stranger wrote into names, paths and fields does nothing: docs/security.md.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "random_store.hpp"

namespace roomatlas::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::array kNames = {
    "<script>document.title='harmed'</script>",
    "'); DROP TABLE rooms;--",
    "\"><img src=x onerror=\"document.title='harmed'\">",
    "</title></svg><svg onload=\"document.title='harmed'\">",
    "&xxe; ]]> <!--",
    "\x1b]0;harmed\x07\x1b[2Jcleared\r",
    "line\nerror: forged",
    "\xc2\x9b"
    "31mred \xe2\x80\xae"
    "derever",
    "not \xff UTF-8",
    "{{plan}} ${harm} %s%n",
};

/// A store whose rooms are called so.
std::string store_of_strangers(const Folder& folder) {
  const std::string store = assembled_store(folder);
  SQLite::Database database(store, SQLite::OPEN_READWRITE);
  SQLite::Statement name(database, "UPDATE rooms SET name = ? WHERE id = ?");
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    name.bind(1, kNames[i]);
    name.bind(2, static_cast<int>(i + 1));
    name.exec();
    name.reset();
  }
  return store;
}

/// Nothing that moves a cursor or begins what the reader of a file obeys: line ends alone.
bool is_free_of_controls(const std::string& text) {
  return std::none_of(text.begin(), text.end(),
                      [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; });
}

void expect_shown_as_text(const Outcome& outcome) {
  for (const std::string& text : {outcome.out, outcome.err}) {
    EXPECT_TRUE(is_free_of_controls(text)) << text;
    EXPECT_THAT(text, Not(HasSubstr("\xc2\x9b")));
    EXPECT_THAT(text, Not(HasSubstr("\xe2\x80\xae")));
    EXPECT_THAT(text, Not(HasSubstr("\nerror: forged")));
  }
}

TEST(Strangers, NamesOfRoomsAreTextInEveryFile) {
  const Folder folder;
  const std::string store = store_of_strangers(folder);
  const std::string out = (folder / "out").string();
  const Outcome exported = run(
      "export " + store + " -f svg,pdf,png,geojson,graphml,csv,nav2,dot,json,ifc,imdf -o " + out);
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  expect_shown_as_text(exported);
  for (const char* file :
       {"plan.svg", "plan.local.geojson", "plan.ifc", "rooms.graphml", "rooms.dot"}) {
    const std::string content = content_of(out + "/" + file);
    EXPECT_NE(content, "") << file;
    EXPECT_TRUE(is_free_of_controls(content)) << file;
  }
  ROOMATLAS_NEEDS("xmllint");
  for (const char* file : {"plan.svg", "rooms.graphml"}) {
    const std::string name = out + "/" + file;
    EXPECT_EQ(run_other("xmllint --noout " + name).exit_code, 0) << content_of(name);
    const std::string harm = "\"//*[local-name()='script'] | //@*[starts-with(name(), 'on')]\"";
    EXPECT_THAT(run_other("xmllint --xpath " + harm + " " + name).out, "");
  }
  SQLite::Database database(store);
  EXPECT_GE(database.execAndGet("SELECT count(*) FROM rooms").getInt(), 10);
}

// A name with a line end would go on as a group of its own.
TEST(Strangers, NamesOfRoomsBeginNoGroupInADxf) {
  const Folder folder;
  const std::string out = (folder / "out").string();
  const Outcome exported = run("-q export " + store_of_strangers(folder) + " -f dxf -o " + out);
  if (exported.exit_code == 2) GTEST_SKIP() << exported.err;
  const std::string content = content_of(out + "/plan.dxf");
  EXPECT_TRUE(is_free_of_controls(content));
  std::istringstream lines(content);
  std::string code;
  std::string value;
  int groups = 0;
  for (; std::getline(lines, code) && std::getline(lines, value); ++groups) {
    ASSERT_EQ(code.find_first_not_of(" 0123456789"), std::string::npos) << groups << ": " << code;
  }
  EXPECT_GT(groups, 1000);
  EXPECT_EQ(value, "EOF");
}

TEST(Strangers, NamesOfRoomsAreShownEscapedOnATerminal) {
  const Folder folder;
  const std::string store = store_of_strangers(folder);
  const std::string other = (folder / "copy.gpkg").string();
  std::filesystem::copy_file(store, other);
  for (const std::string& command :
       {"rename " + store + " 99 Kitchen", "rename " + store + " 3 'line\nerror: forged'",
        "assemble " + store, "evaluate " + store + " --truth " + other,
        "compare " + store + " " + other + " -o " + (folder / "changes").string(),
        "report " + store + " -o " + (folder / "r.html").string()}) {
    const Outcome outcome = run(command);
    EXPECT_THAT(outcome.exit_code, AnyOf(0, 2, 3, 4)) << command << outcome.err;
    expect_shown_as_text(outcome);
  }
}

TEST(Strangers, ThePageRunsNothingOfWhatRoomsAreCalled) {
  ROOMATLAS_NEEDS("chromium");
  const Folder folder;
  const std::string page = (folder / "report.html").string();
  ASSERT_EQ(run("-q report " + store_of_strangers(folder) + " -o " + page).exit_code, 0);
  const std::string probe = R"js(<script>
window.addEventListener('load', () => {
  const layers = [...document.querySelectorAll('#layers input')];
  layers.forEach((box) => { if (!box.checked) box.click(); });
  const rows = [...document.querySelectorAll('#rooms tbody tr')];
  rows.forEach((row) => row.click());
  const result = document.createElement('p');
  result.id = 'probe';
  const named = rows.some((row) => row.textContent.includes("<script>document.title='harmed'"));
  result.textContent = [document.title.includes('harmed'), document.querySelectorAll('img[src="x"]').length,
    document.querySelectorAll('[onload],[onerror]').length, named].join(' ');
  document.body.append(result);
});
</script></body>)js";
  std::string content = content_of(page);
  content.replace(content.rfind("</body>"), 7, probe);
  const auto probed = folder.write("probe.html", content);
  const Outcome shown =
      run_other("timeout 300 chromium --headless --no-sandbox --disable-gpu --user-data-dir=" +
                (folder / "profile").string() + " --virtual-time-budget=5000 --dump-dom file://" +
                probed.string());
  EXPECT_THAT(shown.out, HasSubstr("<p id=\"probe\">false 0 0 true</p>")) << shown.err;
}

TEST(Strangers, FieldsOfLogsAreShownEscaped) {
  const Folder folder;
  const auto log =
      folder.write("esc.clf",
                   "ODOM 0 0 0 0 0 0 1 h 0\n\x1b[31mTAG 1 2\nFLASER 2 1 \x1b]0;x 1 2 3 1 2 3 "
                   "5 h 0\nFLASER 1 7 1 2 3 1 2 3 5 h 0\n");
  const Outcome info = run("info " + log.string());
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.err, HasSubstr("esc.clf:3: FLASER reading 2"));
  expect_shown_as_text(info);
  const std::string missing = (folder / "\x1b[2J.clf").string();
  const Outcome none = run("info '" + missing + "'");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("\\x1b[2J.clf"));
}

TEST(Strangers, PathsInFilesDoNotLeadOutOfTheirFolder) {
  const Folder folder;
  std::filesystem::create_directories(folder / "maps");
  (void)folder.write("secret.pgm", "P2 3 3 255\n0 0 0 0 254 0 0 0 0\n");
  for (const char* image :
       {"/etc/passwd", "/dev/zero", "../secret.pgm", "a/../../secret.pgm", "."}) {
    const auto map = folder.write("maps/map.yaml", std::string("image: ") + image +
                                                       "\nresolution: 0.05\norigin: [0, 0, 0]\n");
    const Outcome outcome = run("-q simulate " + map.string() + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.exit_code, 3) << image;
    EXPECT_THAT(outcome.err, HasSubstr("map.yaml:1: image: expected")) << image;
  }
  (void)folder.write("secret_0.db3", "SQLite format 3");
  for (const char* part : {"/etc/passwd", "../secret_0.db3"}) {
    (void)folder.write(
        "maps/metadata.yaml",
        std::string("rosbag2_bagfile_information:\n  relative_file_paths:\n    - ") + part + "\n");
    const Outcome outcome = run("-q info " + (folder / "maps").string());
    EXPECT_EQ(outcome.exit_code, 3) << part;
    EXPECT_THAT(outcome.err, HasSubstr("without its recordings")) << part;
  }
}

TEST(Strangers, ViewsOfARecordingAreNotExecuted) {
  const Folder folder;
  const std::string bag = (folder / "run.db3").string();
  SQLite::Database database(bag, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(
      "CREATE TABLE topics(id, name, type, serialization_format);"
      "INSERT INTO topics VALUES(1, '/scan', 'sensor_msgs/msg/LaserScan', 'cdr');"
      "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
      "SELECT i AS id, 1 AS topic_id, i AS timestamp, zeroblob(9) AS data FROM n");
  const Outcome outcome = run("-q info " + bag);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
}

TEST(Strangers, ALineEndInTheNameOfALogMakesNoLineOfItsOwn) {
  const Folder folder;
  const std::string made = (folder / "m").string();
  ASSERT_EQ(run("-q simulate " + kTwoRooms + " --sensor laser -o " + made).exit_code, 0);
  const std::filesystem::path log = folder / "a\nwarning: b.clf";
  std::filesystem::rename(made + "/mission.clf", log);
  const Outcome mapped = run("map '" + log.string() + "' -o " + (folder / "b.gpkg").string());
  EXPECT_EQ(mapped.exit_code, 0) << mapped.err;
  EXPECT_THAT(mapped.err, HasSubstr("a\\x0awarning: b.clf: "));
  EXPECT_THAT(mapped.err, ::testing::Not(HasSubstr("\nwarning: b")));
}

}  // namespace
}  // namespace roomatlas::test
