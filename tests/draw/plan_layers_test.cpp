// SPDX-License-Identifier: GPL-3.0-or-later
// The layers that say more than the walls: limits, widths, corrections, uncertainty, north.
#include <gmock/gmock.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "../../src/draw/label_space.hpp"
#include "../../src/draw/style.hpp"
#include "draw/plan_fixture.hpp"

namespace roomatlas {
namespace {

using test::annotations;
using test::office;
using ::testing::HasSubstr;
using ::testing::Not;

pugi::xml_document drawn(const PlanAnnotations& notes, const DrawOptions& options) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(draw_plan(office(), notes, options).c_str()));
  return document;
}

pugi::xml_node group(const pugi::xml_document& document, const std::string& id) {
  return document.select_node(("//g[@id='" + id + "']").c_str()).node();
}

/// The points of `M x y L x y ...`.
std::vector<Point2> points_of(std::string path) {
  for (char& c : path) {
    if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
  }
  std::istringstream stream(path);
  std::vector<Point2> points;
  for (Point2 point; stream >> point.x() >> point.y();) points.push_back(point);
  return points;
}

TEST(PlanLayers, UnexploredLimitsAreDashedAndExplained) {
  PlanAnnotations notes = annotations();
  notes.unexplored = {{{18, 3}, {18, 6}}};
  const auto document = drawn(notes, {});
  const pugi::xml_node layer = group(document, "unexplored");
  const pugi::xml_node line = layer.select_node(".//path[@class='unexplored']").node();
  EXPECT_NEAR(
      (points_of(line.attribute("d").value())[1] - points_of(line.attribute("d").value())[0])
          .norm(),
      30.0, 1e-3);  // 3 m at 1:100
  EXPECT_TRUE(line.parent().attribute("stroke-dasharray"));
  EXPECT_THAT(draw_plan(office(), notes, {}), HasSubstr(">unexplored</text>"));
  EXPECT_THAT(draw_plan(office(), annotations(), {}), Not(HasSubstr(">unexplored</text>")));
}

TEST(PlanLayers, TheBlankBesideAnUnexploredLimitIsOnItsRight) {
  PlanAnnotations notes = annotations();
  notes.unexplored = {{{18, 3}, {18, 6}}};  // upwards: free space on the left, blank on the right
  const auto document = drawn(notes, {});
  const auto ring =
      points_of(group(document, "unexplored").first_child().first_child().attribute("d").value());
  ASSERT_EQ(ring.size(), 4U);
  for (const Point2& corner : ring) EXPECT_GE(corner.x(), ring[0].x() - 1e-9);
  EXPECT_GT(ring[2].x(), ring[0].x() + 1.0);
}

TEST(PlanLayers, ADoorsWidthStandsInARoomBesideItAndOnNoLabel) {
  const auto document = drawn(annotations(), {});
  const pugi::xml_node text = group(document, "door-widths").child("text");
  EXPECT_STREQ(text.text().get(), "0.90");
  EXPECT_STREQ(text.attribute("data-door").value(), "1");
}

TEST(PlanLayers, CorrectionsAreArrowsFromBeforeToAfter) {
  PlanAnnotations notes = annotations();
  notes.corrections = {{{1, 1}, {3, 1}}, {{5, 5}, {5, 5}}};  // the second did not move
  DrawOptions options;
  options.show_corrections = true;
  const auto document = drawn(notes, options);
  const auto arrows = group(document, "corrections").select_nodes(".//path");
  ASSERT_EQ(arrows.size(), 1U);
  const auto points = points_of(arrows.first().node().attribute("d").value());
  EXPECT_NEAR(points[1].x() - points[0].x(), 20.0, 1e-3);
  EXPECT_LT(points[2].x(), points[1].x());  // barbs point back
}

TEST(PlanLayers, UncertaintyIsTheEllipseThatHolds95Percent) {
  PlanAnnotations notes = annotations();
  Eigen::Matrix2d covariance;
  const double sigma_m = 0.1;
  covariance << 2.5, 1.5, 1.5, 2.5;  // axes at 45 degrees: variances 4 and 1
  notes.uncertainty = {{{2, 4}, covariance * sigma_m * sigma_m}};
  DrawOptions options;
  options.show_uncertainty = true;
  const auto document = drawn(notes, options);
  const pugi::xml_node ellipse = group(document, "uncertainty").child("ellipse");
  const double quantile = std::sqrt(-2.0 * std::log(0.05));  // of a radius in two dimensions
  EXPECT_NEAR(ellipse.attribute("rx").as_double(), 10.0 * quantile * 2.0 * sigma_m, 2e-3);
  EXPECT_NEAR(ellipse.attribute("ry").as_double(), 10.0 * quantile * sigma_m, 2e-3);
  double turn = 0.0;
  ASSERT_EQ(std::sscanf(ellipse.attribute("transform").value(), "rotate(%lf", &turn), 1);
  EXPECT_NEAR(std::abs(std::remainder(turn + 45.0, 180.0)), 0.0, 0.01);  // up to the right
}

TEST(PlanLayers, TheNorthArrowPointsWhereNorthIs) {
  for (const double north_deg : {0.0, 30.0, -90.0, 200.0}) {
    DrawOptions options;
    options.north_deg = north_deg;
    const auto document = drawn(annotations(), options);
    const pugi::xml_node north = group(document, "north");
    const auto half = points_of(north.child("path").attribute("d").value());
    const Point2 arrow = half[0] - half[1];  // from the notch to the tip; y is down
    EXPECT_NEAR(std::remainder(degrees(std::atan2(arrow.x(), -arrow.y())) - north_deg, 360.0), 0.0,
                0.05);
    EXPECT_STREQ(north.child("text").text().get(), "N");
    EXPECT_FALSE(group(document, "axes"));
  }
}

TEST(PlanLayers, TheEstimatedAccuracyStandsInTheTitleBlock) {
  PlanAnnotations notes = annotations();
  EXPECT_THAT(draw_plan(office(), notes, {}), Not(HasSubstr("Accuracy")));
  notes.accuracy = PlanAccuracy{{}, 0.0412, {}, 0.0, {}};
  EXPECT_THAT(draw_plan(office(), notes, {}), HasSubstr("\u00b1\u00a00.04\u00a0m"));
}

// Simulated with the matrices of Machado, Oliveira and Fernandes (2009), severity 1, on linear
// RGB; distances in CIE Lab, where 2.3 is a difference that people just notice.
using Rgb = Eigen::Vector3d;

Rgb linear(const std::string& hex) {
  Rgb rgb;
  for (int i = 0; i < 3; ++i) {
    const double c =
        std::stoi(hex.substr(1 + 2 * static_cast<std::size_t>(i), 2), nullptr, 16) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

Eigen::Vector3d lab(const Rgb& rgb) {
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d white(0.9505, 1.0, 1.089);
  const Eigen::Vector3d f = (xyz_from_rgb * rgb).cwiseQuotient(white).unaryExpr([](double t) {
    return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
  });
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

TEST(PlanLayers, TintsOfRoomsStayApartForColourBlindReaders) {
  Eigen::Matrix3d protanopia, deuteranopia, tritanopia;
  protanopia << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  deuteranopia << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  tritanopia << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  const std::array<RoomKind, 3> kinds = {RoomKind::room, RoomKind::corridor, RoomKind::hall};
  for (const Eigen::Matrix3d& eye :
       {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), protanopia, deuteranopia, tritanopia}) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Rgb a = (eye * linear(drawing::tint(kinds[i]))).cwiseMax(0.0).cwiseMin(1.0);
        const Rgb b = (eye * linear(drawing::tint(kinds[j]))).cwiseMax(0.0).cwiseMin(1.0);
        EXPECT_GT((lab(a) - lab(b)).norm(), 3.0 * 2.3)
            << to_string(kinds[i]) << " and " << to_string(kinds[j]);
      }
    }
  }
}

}  // namespace
}  // namespace roomatlas
