// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/draw/label_space.hpp"
#include "../../src/draw/room_labels.hpp"
#include "draw/plan_fixture.hpp"

#include "roomatlas/draw/report.hpp"

#include <gmock/gmock.h>
#include <pugixml.hpp>

#include <limits>

namespace roomatlas {
namespace {

using drawing::RoomLabel;
using drawing::Sheet;
using test::annotations;
using test::office;

pugi::xml_document parsed_plan(const std::string& svg) {
  pugi::xml_document document;
  const auto result = document.load_string(svg.c_str());
  EXPECT_TRUE(result) << result.description();
  return document;
}

/// All text elements, joined by line breaks.
std::string text_of(const pugi::xml_document& document) {
  std::string text;
  for (const auto& node : document.select_nodes("//text")) {
    text += node.node().text().get();
    text += '\n';
  }
  return text;
}

pugi::xml_node group(const pugi::xml_document& document, const std::string& id) {
  return document.select_node(("//g[@id='" + id + "']").c_str()).node();
}

TEST(DrawPlan, IsWellFormedAndMeasuredInMillimetresOfPaper) {
  const auto document = parsed_plan(draw_plan(office(), annotations(), {}));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("width").value(), "297mm");
  EXPECT_STREQ(svg.attribute("height").value(), "210mm");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 297 210");
}

TEST(DrawPlan, HasTheLayersUnderTheirIds) {
  const auto document = parsed_plan(draw_plan(office(), annotations(), {}));
  for (const char* id : {"rooms", "walls", "doors", "trajectory", "room-graph", "labels",
                         "furniture", "title", "dimensions", "scale-bar", "legend", "unexplored",
                         "corrections", "uncertainty", "door-widths", "axes", "edges", "notes"}) {
    EXPECT_TRUE(group(document, id)) << id;
  }
  EXPECT_STREQ(group(document, "walls").attribute("class").value(), "layer");
}

TEST(DrawPlan, WritesEveryNameAsText) {
  const std::string text = text_of(parsed_plan(draw_plan(office(), annotations(), {})));
  for (const char* word : {"Lab <A&B>\n", "2\n", "Conference room", "4\n", "Closet", "Cupboard"}) {
    EXPECT_THAT(text, testing::HasSubstr(word));
  }
  EXPECT_THAT(text, testing::HasSubstr("28.8\u00a0m\u00b2"));
}

TEST(DrawPlan, TitleBlockSaysWhatItIsAndWhatItIsNot) {
  const std::string text = text_of(parsed_plan(draw_plan(office(), annotations(), {})));
  for (const char* word : {"Office", "office.clf.gz", "2003-02-19", "391\u00a0m", "Not a survey",
                           "1\u2009:\u2009100", "A4 landscape", "corridor", "19.90\u00a0m"}) {
    EXPECT_THAT(text, testing::HasSubstr(word));
  }
}

TEST(DrawPlan, TitleBlockDoesNotNameTheMissionTwice) {
  FloorPlan plan = office();
  plan.title = annotations().mission;
  const std::string text = text_of(parsed_plan(draw_plan(plan, annotations(), {})));
  EXPECT_THAT(text, testing::HasSubstr("Floor plan\nMission office.clf.gz\n"));
}

TEST(DrawPlan, TitleBlockOfAMapNamesNoMission) {
  FloorPlan plan = office();
  PlanAnnotations of_map;
  of_map.mission = plan.title = "office.yaml";
  const std::string text = text_of(parsed_plan(draw_plan(plan, of_map, {})));
  EXPECT_THAT(text, testing::HasSubstr("Floor plan\nMap office.yaml\n"));
}

TEST(DrawPlan, HoldsEveryLayerButDisplaysPathAndGraphOnlyWhenAsked) {
  const auto is_displayed = [](const pugi::xml_node& layer) { return !layer.attribute("display"); };
  const auto plain = parsed_plan(draw_plan(office(), annotations(), {}));
  const auto full = parsed_plan(draw_plan(office(), annotations(), {true, true, true, true, {}}));
  for (const char* id : {"trajectory", "room-graph", "corrections", "uncertainty"}) {
    EXPECT_FALSE(is_displayed(group(plain, id))) << id;
    EXPECT_TRUE(is_displayed(group(full, id))) << id;
  }
  EXPECT_TRUE(group(plain, "trajectory").child("path"));
  EXPECT_EQ(group(plain, "room-graph").select_nodes("path").size(), 1U);  // 99 is not in the plan
  for (const char* id : {"rooms", "walls", "doors", "labels", "door-widths", "title"}) {
    EXPECT_TRUE(is_displayed(group(plain, id))) << id;
  }
}

TEST(DrawPlan, TurnsTheBuildingsYUp) {
  const Sheet sheet = drawing::choose_sheet({{0, 0}, {10, 5}}, 0.0);
  const Point2 low = sheet.to_paper(Point2(1, 1));
  const Point2 high = sheet.to_paper(Point2(1, 2));
  EXPECT_DOUBLE_EQ(low.x(), high.x());
  EXPECT_NEAR(low.y() - high.y(), 1000.0 / sheet.scale, 1e-9);
}

TEST(DrawPlan, ChoosesPaperAndARoundScaleThatFit) {
  const auto sheet = [](double width, double height) {
    return drawing::choose_sheet({{0, 0}, {width, height}}, 0.0);
  };
  EXPECT_EQ(sheet(8, 5).paper, "A4 landscape");
  EXPECT_EQ(sheet(8, 5).scale, 50);
  EXPECT_EQ(sheet(5, 8).paper, "A4 portrait");
  EXPECT_EQ(sheet(30, 15).paper, "A3 landscape");
  EXPECT_EQ(sheet(30, 15).scale, 100);
  EXPECT_EQ(sheet(140, 60).paper, "A1 landscape");
  EXPECT_EQ(sheet(140, 60).scale, 200);
  EXPECT_EQ(sheet(53, 53).paper, "A3 landscape");
  EXPECT_EQ(sheet(53, 53).scale, 250);
  EXPECT_EQ(sheet(40, 14).paper, "A3 landscape");
  EXPECT_EQ(sheet(40, 14).scale, 125);
  EXPECT_EQ(sheet(900, 60).scale, 1250);
  for (const double size : {3.0, 17.0, 66.0, 412.0, 5000.0}) {
    const Sheet chosen = sheet(size, size / 2.0);
    EXPECT_TRUE((chosen.content_mm.min.array() > chosen.drawing_mm.min.array()).all());
    EXPECT_TRUE((chosen.content_mm.max.array() < chosen.drawing_mm.max.array()).all());
  }
}

TEST(DrawPlan, LabelsLieInTheirRoomsAndNeverOverlap) {
  const FloorPlan plan = office();
  const Sheet sheet = drawing::choose_sheet({{-0.2, 0}, {19.7, 11}}, 0.0);
  const auto labels = drawing::place_labels(plan, sheet, {});
  ASSERT_EQ(labels.size(), plan.rooms.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(drawing::overlap(labels[i].box_mm(), labels[j].box_mm())) << i << ' ' << j;
    }
    if (labels[i].leader_to_mm) continue;
    const auto room = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                   [&](const PlanRoom& r) { return r.id == labels[i].room; });
    EXPECT_TRUE(drawing::is_inside(sheet.to_paper(room->parts).front(), labels[i].box_mm()))
        << room->name;
  }
}

TEST(DrawPlan, SmallRoomsGetSmallerTurnedOrOutsideLabels) {
  const FloorPlan plan = office();
  const Sheet sheet = drawing::choose_sheet({{-0.2, 0}, {19.7, 11}}, 0.0);
  const auto labels = drawing::place_labels(plan, sheet, {});
  const auto label = [&](RoomId id) {
    return *std::find_if(labels.begin(), labels.end(),
                         [&](const RoomLabel& candidate) { return candidate.room == id; });
  };
  EXPECT_FALSE(label(1).is_turned);
  EXPECT_GT(label(1).lines.front().size_mm, 3.0);
  EXPECT_LT(label(5).lines.front().size_mm, label(1).lines.front().size_mm);
  EXPECT_TRUE(label(6).leader_to_mm.has_value() || !label(6).shows_area);
}

TEST(DrawPlan, SaysTheAreasThatLabelsCouldNot) {
  FloorPlan plan = office();
  for (RoomId id = 10; id < 14; ++id) {  // a row of lockers in the middle of the hall
    const double x = 8.0 + 0.3 * static_cast<double>(id - 9);
    plan.rooms.push_back(
        test::room(id, std::to_string(id), RoomKind::room, {{x, 5.0}, {x + 0.25, 5.25}}));
  }
  const std::string text = text_of(parsed_plan(draw_plan(plan, annotations(), {})));
  for (RoomId id = 10; id < 14; ++id) {
    EXPECT_THAT(text, testing::HasSubstr(std::to_string(id)));
  }
}

TEST(DrawPlan, AnEmptyPlanGivesAPageThatSaysSo) {
  const auto document = parsed_plan(draw_plan({}, {}, {}));
  EXPECT_THAT(text_of(document), testing::HasSubstr("This plan is empty"));
  EXPECT_TRUE(group(document, "rooms"));
}

TEST(DrawPlan, IsTheSameEveryTime) {
  EXPECT_EQ(draw_plan(office(), annotations(), {true, true, true, true, {}}),
            draw_plan(office(), annotations(), {true, true, true, true, {}}));
}

TEST(DrawPlan, NeverWritesNotANumber) {
  PlanAnnotations notes = annotations();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  notes.trajectory.insert(notes.trajectory.begin(), Point2(nan, 0));
  const std::string svg = draw_plan(office(), notes, {true, true, true, true, {}});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(DrawPlan, LabelsOverLinesHaveAHaloBeneathPlainText) {
  DrawOptions options;
  options.show_room_graph = true;
  const auto document = parsed_plan(draw_plan(office(), annotations(), options));
  int halos = 0;
  for (const pugi::xpath_node found : document.select_nodes("//g[@id='labels']//text")) {
    const pugi::xml_node text = found.node();
    if (std::string(text.attribute("class").value()) != "halo") {
      EXPECT_FALSE(text.attribute("stroke")) << text.text().get();
      continue;
    }
    ++halos;
    const pugi::xml_node above = text.next_sibling("text");
    EXPECT_STREQ(above.text().get(), text.text().get());
    EXPECT_FALSE(above.attribute("class"));
  }
  EXPECT_GT(halos, 0);
}

TEST(ReportPage, PutsTitleAndDataInTheirPlacesAndNothingThatEndsTheScript) {
  const std::string page = report_page("A <b> & c", R"({"name":"</script>"})");
  EXPECT_THAT(page, testing::HasSubstr("<title>A &lt;b&gt; &amp; c</title>"));
  EXPECT_THAT(page, testing::HasSubstr(R"(id="data">{"name":"\u003c/script>"}</script>)"));
  EXPECT_THAT(page, testing::HasSubstr("Leaflet"));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("{{")));
}

TEST(OpeningsText, CountsDoorsPassagesAndWindowsEachByItself) {
  FloorPlan plan;
  EXPECT_EQ(openings_text(plan), "0 doors");
  for (const DoorKind kind : {DoorKind::door, DoorKind::window, DoorKind::passage, DoorKind::door,
                              DoorKind::window, DoorKind::door}) {
    plan.doors.emplace_back().kind = kind;
  }
  EXPECT_EQ(openings_text(plan), "3 doors, 1 passage, 2 windows");
  EXPECT_EQ(count_of(plan, DoorKind::passage), 1U);
}

}  // namespace
}  // namespace roomatlas
