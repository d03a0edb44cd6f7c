// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/changes.hpp"

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include "plan_fixture.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

Polygon square(double x, double y) {
  return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, {}};
}

PlanChanges changes() {
  PlanChanges found;
  Change moved;
  moved.id = 1;
  moved.kind = ChangeKind::furniture_moved;
  moved.gone = {square(1, 3)};
  moved.appeared = {square(3, 3)};
  moved.at = {3.5, 3.5};
  moved.room_name = "Lab <A&B>";
  Change wall;
  wall.id = 2;
  wall.kind = ChangeKind::wall_new;
  wall.appeared = {square(9, 3)};
  wall.at = {9.5, 3.5};
  found.changes = {moved, wall};
  found.rooms = {{5, "Closet", true, 2.0, 0.2}};
  found.not_seen_again = {square(18.2, 0.5)};
  found.compared_m2 = 81.4;
  return found;
}

pugi::xml_document drawn(const PlanChanges& found) {
  pugi::xml_document document;
  const std::string svg = draw_changes(test::office(), test::office(), found,
                                       {"old.clf", "2024-01-02", "new.clf", "2025-01-02"}, {});
  EXPECT_TRUE(document.load_string(svg.c_str()));
  return document;
}

std::size_t count(const pugi::xml_document& document, const std::string& query) {
  return document.select_nodes(query.c_str()).size();
}

TEST(DrawChanges, GoneAndNewAreLayersOfTheirOwn) {
  const auto document = drawn(changes());
  EXPECT_EQ(count(document, "//g[@id='gone']/path"), 1U);
  EXPECT_EQ(count(document, "//g[@id='new']/path"), 2U);
  EXPECT_EQ(count(document, "//g[@id='not-seen-again']/path"), 1U);
  EXPECT_EQ(count(document, "//g[@id='numbers']/circle"), 2U);
  EXPECT_EQ(count(document, "//g[@id='scale-bar']"), 1U);
}

TEST(DrawChanges, NumbersAreNamedBelow) {
  const auto document = drawn(changes());
  const std::string note = document.select_node("//g[@id='notes']/text").node().text().get();
  EXPECT_THAT(note, HasSubstr("1\u00a0furniture moved (Lab <A&B>)"));
  EXPECT_THAT(note, HasSubstr("2\u00a0wall new"));
  EXPECT_THAT(note, HasSubstr("not visited again: Closet"));
  EXPECT_EQ(count(document, "//text[.='From old.clf, 2024-01-02']"), 1U);
}

TEST(DrawChanges, NothingToTellIsSaid) {
  const auto document = drawn({});
  EXPECT_EQ(count(document, "//text[.='Nothing changed in what both missions saw.']"), 1U);
  EXPECT_EQ(count(document, "//g[@id='gone']/path"), 0U);
}

}  // namespace
}  // namespace roomatlas
