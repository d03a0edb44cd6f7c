// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/draw/plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "../../src/draw/axis.hpp"

namespace roomatlas {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Axis, HasRoundTicksThatEncloseTheValues) {
  EXPECT_THAT(drawing::linear_axis(0.0, 0.43, 8).ticks,
              ElementsAre(0.0, 0.1, 0.2, 0.30000000000000004, 0.4, 0.5));
  EXPECT_THAT(drawing::linear_axis(3.0, 61.0, 4).ticks, ElementsAre(0, 20, 40, 60, 80));
  EXPECT_THAT(drawing::linear_axis(1000.0, 1061.0, 8).ticks.front(), 1000.0);
  EXPECT_THAT(drawing::logarithmic_axis(0.03, 61.0).ticks, ElementsAre(0.01, 0.1, 1, 10, 100));
}

TEST(Axis, HasAtMostAsManyStepsAsThereIsRoomForWhateverTheValues) {
  for (double low = -7.3; low < 100.0; low += 3.7) {
    for (double length = 1e-4; length < 1e5; length *= 1.37) {
      const drawing::Axis axis = drawing::linear_axis(low, low + length, 8);
      ASSERT_LE(axis.ticks.size(), 9U) << low << " " << length;
      ASSERT_GE(axis.ticks.size(), 2U);
      ASSERT_LE(axis.low, low + 1e-6 * length);
      ASSERT_GE(axis.high, low + length - 1e-6 * length);
    }
  }
}

TEST(Axis, OfOneValueStillHasALength) {
  const drawing::Axis axis = drawing::linear_axis(0.0, 0.0, 8);
  EXPECT_GT(axis.high, axis.low);
}

TEST(Axis, WritesTicksWithTheDecimalsOfItsSteps) {
  const drawing::Axis axis = drawing::linear_axis(0.0, 0.038, 8);
  EXPECT_EQ(drawing::tick_text(axis, axis.ticks[1]), "0.005");
  EXPECT_EQ(drawing::tick_text(drawing::linear_axis(0, 700, 8), 100.0), "100");
  EXPECT_EQ(drawing::tick_text(drawing::logarithmic_axis(0.001, 100), 0.001), "0.001");
}

const std::vector<PlotSeries> kSeries = {{"one", {0, 1, 2, 3}, {0.1, 0.3, std::nan(""), 0.2}},
                                         {"two & three", {0, 1, 2}, {0.2, 0.1, 0.15}}};

pugi::xml_document parsed_plot(const std::string& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(svg.c_str()));
  return document;
}

TEST(PlotOver, DrawsEachSeriesOnceAndBreaksTheLineAtWhatIsNotFinite) {
  const auto document = parsed_plot(plot_over({"Error", "time (s)", "error (m)"}, kSeries, true));
  const auto values = document.document_element().find_child_by_attribute("g", "id", "values");
  const auto paths = values.children("path");
  EXPECT_EQ(std::distance(paths.begin(), paths.end()), 2);
  const std::string first = values.child("path").attribute("d").value();
  EXPECT_EQ(std::count(first.begin(), first.end(), 'M'), 2);
  EXPECT_EQ(std::count(first.begin(), first.end(), 'L'), 1);
}

TEST(PlotOver, NamesAxesAndSeriesAndDoesNotChangeFromRunToRun) {
  const std::string svg = plot_over({"Error", "time (s)", "error (m)"}, kSeries, false);
  EXPECT_THAT(svg, HasSubstr("time (s)"));
  EXPECT_THAT(svg, HasSubstr("two &amp; three"));
  EXPECT_EQ(svg, plot_over({"Error", "time (s)", "error (m)"}, kSeries, false));
}

TEST(PlotHistogram, ShowsSharesThatAddUpToTheWhole) {
  // Heights above the axis, times the bins' width, are the same area for any number of values.
  const auto area_of = [](const std::vector<double>& values) {
    const auto document = parsed_plot(
        plot_histogram({"h", "x", "share (%)"}, {{"fixed", {}, {0.0, 1.0}}, {"s", {}, values}}));
    const auto values_group =
        document.document_element().find_child_by_attribute("g", "id", "values");
    std::istringstream path(values_group.last_child().attribute("d").value());
    std::vector<Point2> points;
    for (char letter = 0; path >> letter;) {
      Point2 point;
      path >> point.x() >> point.y();
      points.push_back(point);
    }
    return std::abs(signed_area(points));
  };
  EXPECT_NEAR(area_of({0.05, 0.15, 0.15, 0.95}), area_of({0.0, 1.0, 0.3, 0.3, 0.7, 0.7, 0.5, 0.5}),
              5.0);
}

TEST(PlotMap, IsDarkerWhereTheErrorIsLarger) {
  const auto document =
      parsed_plot(plot_map("m", "m", {{0, 0}, {5, 5}}, {0.01, 1.0}, {{0, 0}, {5, 5}}));
  const auto places = document.document_element().find_child_by_attribute("g", "id", "places");
  const auto brightness = [](const pugi::xml_node& path) {
    const std::string colour = path.attribute("stroke").value();
    return std::stoi(colour.substr(1, 2), nullptr, 16) +
           std::stoi(colour.substr(3, 2), nullptr, 16) +
           std::stoi(colour.substr(5, 2), nullptr, 16);
  };
  EXPECT_GT(brightness(places.first_child()), brightness(places.last_child()));
}

TEST(Plots, OfNothingSaySo) {
  for (const std::string& svg :
       {plot_over({"t", "x", "y"}, {}, true), plot_histogram({"t", "x", "y"}, {}),
        plot_map("t", "m", {}, {}, {}),
        plot_over({"t", "x", "y"}, {{"a", {1}, {std::nan("")}}}, true)}) {
    EXPECT_THAT(svg, HasSubstr("nothing to draw"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
  }
}

}  // namespace
}  // namespace roomatlas
