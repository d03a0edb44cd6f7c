// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

/// What the mission says of the plan: the path, what the correction moved, how sure it is.
namespace roomatlas::drawing {
namespace {

constexpr double kPathStep_mm = 0.25;      // nearer points of a path are not drawn
constexpr double kShortestArrow_mm = 0.3;  // shorter ones look like specks

/// The path on paper, without the points that nobody could tell apart.
Polyline thinned(const Polyline& trajectory, const Sheet& sheet) {
  Polyline line;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!trajectory[i].allFinite()) continue;
    const Point2 at = sheet.to_paper(trajectory[i]);
    const bool is_last = i + 1 == trajectory.size();
    if (line.empty() || is_last || (at - line.back()).norm() >= kPathStep_mm) line.push_back(at);
  }
  return line;
}

/// A line with two barbs at its end.
Polyline arrow(const Point2& from, const Point2& to) {
  const double head_mm = std::min(1.4, 0.35 * (to - from).norm());
  const Point2 back = -(to - from).normalized() * head_mm;
  const Point2 side(-0.4 * back.y(), 0.4 * back.x());
  return {from, to, to + back + side, to, to + back - side};
}

/// A window on the sheet: odometry may have been anywhere.
std::string add_clip(pugi::xml_node layer, const Box2& window_mm) {
  const char* const id = "sheet-window";
  add_rectangle(add(layer, "clipPath", {{"id", id}}), window_mm, {});
  return std::string("url(#") + id + ")";
}

}  // namespace

PathStyle path_style(std::size_t mission) {
  constexpr std::array kDashes = {"", "1.6 0.5", "0.5 0.4"};
  return {kMissionStrokes[mission % kMissionStrokes.size()],
          kDashes[mission / kMissionStrokes.size() % kDashes.size()]};
}

void add_mission_paths(pugi::xml_node svg, const std::vector<MissionPath>& missions, bool is_shown,
                       const Sheet& sheet) {
  pugi::xml_node layer =
      add_layer(svg, "trajectory", is_shown,
                {{"fill", "none"}, {"stroke-width", kThin_mm}, {"stroke-linejoin", "round"}});
  for (std::size_t i = 0; i < missions.size(); ++i) {
    const Polyline line = thinned(missions[i].path, sheet);
    if (line.size() < 2) continue;
    const PathStyle style = path_style(i);
    Attributes attributes = {{"stroke", style.stroke}, {"d", path_of(line)}};
    if (*style.dash != '\0') attributes.emplace_back("stroke-dasharray", style.dash);
    pugi::xml_node path = add(layer, "path", attributes);
    add(path, "title", {}).text().set(missions[i].name.c_str());
  }
}

void add_trajectory(pugi::xml_node svg, const Polyline& trajectory, bool is_shown,
                    const Sheet& sheet) {
  pugi::xml_node layer = add_layer(svg, "trajectory", is_shown,
                                   {{"fill", "none"},
                                    {"stroke", kPathStroke},
                                    {"stroke-width", kThin_mm},
                                    {"stroke-linejoin", "round"}});
  const Polyline line = thinned(trajectory, sheet);
  if (line.size() > 1) add(layer, "path", {{"d", path_of(line)}});
}

void add_corrections(pugi::xml_node svg, const std::vector<Segment2>& corrections, bool is_shown,
                     const Sheet& sheet) {
  pugi::xml_node layer = add_layer(svg, "corrections", is_shown,
                                   {{"fill", "none"},
                                    {"stroke", kCorrectionStroke},
                                    {"stroke-width", kThin_mm},
                                    {"stroke-linejoin", "round"}});
  pugi::xml_node arrows = add(layer, "g", {{"clip-path", add_clip(layer, sheet.drawing_mm)}});
  for (const Segment2& moved : corrections) {
    if (!moved.a.allFinite() || !moved.b.allFinite()) continue;
    const Point2 from = sheet.to_paper(moved.a);
    const Point2 to = sheet.to_paper(moved.b);
    if ((to - from).norm() < kShortestArrow_mm) continue;
    add(arrows, "path", {{"class", "correction"}, {"d", path_of(arrow(from, to))}});
  }
}

void add_uncertainty(pugi::xml_node svg, const std::vector<UncertainPlace>& places, bool is_shown,
                     const Sheet& sheet) {
  constexpr double kQuantile95 = 2.4477;  // of the square root of chi-square with two degrees
  pugi::xml_node layer =
      add_layer(svg, "uncertainty", is_shown,
                {{"fill", "none"}, {"stroke", kUncertaintyStroke}, {"stroke-width", kThin_mm}});
  for (const UncertainPlace& place : places) {
    if (!place.at.allFinite() || !place.covariance_m2.allFinite()) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(place.covariance_m2);
    const Eigen::Vector2d radii_mm =
        kQuantile95 * sheet.to_paper.mm_per_m * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    const Eigen::Vector2d longest = axes.eigenvectors().col(1);
    const Point2 at = sheet.to_paper(place.at);
    const Point2 on_paper = sheet.to_paper.direction(longest);
    const double turn_deg = degrees(std::atan2(on_paper.y(), on_paper.x()));
    add(layer, "ellipse",
        {{"cx", number(at.x())},
         {"cy", number(at.y())},
         {"rx", number(radii_mm[1])},
         {"ry", number(radii_mm[0])},
         {"transform",
          "rotate(" + number(turn_deg) + " " + number(at.x()) + " " + number(at.y()) + ")"}});
  }
}

}  // namespace roomatlas::drawing
