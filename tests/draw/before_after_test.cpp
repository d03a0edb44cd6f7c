// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/draw.hpp"

#include <gmock/gmock.h>
#include <pugixml.hpp>

namespace roomatlas {
namespace {

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(svg.c_str()));
  return document;
}

const WallSketch kBefore{"Raw <odometry>", {{{0, 0}, {30, 0}, {30, 20}}}, {{1, 1}, {29, 19}}};
const WallSketch kAfter{"Corrected", {{{0, 0}, {10, 0}}}, {{1, 1}, {9, 1}}};

/// Width on paper of the first line of a path "Mx yLx y...".
double first_line_mm(const pugi::xml_document& document, const char* panel) {
  const std::string query = std::string("//g[@id='") + panel + "']/path[@class='walls']";
  const std::string d = document.select_node(query.c_str()).node().attribute("d").value();
  const double from = std::stod(d.substr(1));
  const double to = std::stod(d.substr(d.find('L') + 1));
  return to - from;
}

TEST(DrawBeforeAfter, ShowsBothPanelsAtOneScale) {
  const auto document = parsed(draw_before_after(kBefore, kAfter));
  EXPECT_NEAR(first_line_mm(document, "before"), 3.0 * first_line_mm(document, "after"), 0.01);
}

TEST(DrawBeforeAfter, HasCaptionsAndAScaleBar) {
  const auto document = parsed(draw_before_after(kBefore, kAfter));
  EXPECT_STREQ(document.select_node("//g[@id='before']/text").node().text().get(),
               "Raw <odometry>");
  EXPECT_STREQ(document.select_node("//g[@id='after']/text").node().text().get(), "Corrected");
  EXPECT_TRUE(document.select_node("//g[@id='scale-bar']"));
}

TEST(DrawBeforeAfter, SurvivesEmptySketches) {
  const auto document = parsed(draw_before_after({}, {}));
  EXPECT_EQ(document.select_nodes("//text[.='nothing to draw']").size(), 2U);
}

}  // namespace
}  // namespace roomatlas
