// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <string>
#include <vector>

namespace roomatlas::drawing {

constexpr double kMargin_mm = 10.0;     // what office printers leave blank, and a little
constexpr double kStrip_mm = 30.0;      // the title block along the lower edge
constexpr double kDimension_mm = 17.0;  // beside and below the drawing, for two rows of dimensions
constexpr double kPadding_mm = 6.0;     // above and right of the drawing

constexpr double kMillimetres = 1000.0;     // a metre
constexpr double kComparison_mm = 297.0;    // width of pictures that set panels side by side ...
constexpr double kComparisonEdge_mm = 6.0;  // ... and what they leave blank around

/// Building metres to millimetres on paper: y turns from up to down.
struct PaperTransform {
  double mm_per_m = 10.0;  ///< of the scale
  Point2 offset_mm = Point2::Zero();
  Point2 right = Point2(1.0, 0.0);  ///< what lies to the right on the sheet; building axes, unit

  [[nodiscard]] Point2 operator()(const Point2& point_m) const;
  /// A unit vector of the building on the sheet.
  [[nodiscard]] Point2 direction(const Point2& building) const;
  [[nodiscard]] Polyline operator()(const Polyline& line_m) const;
  [[nodiscard]] std::vector<Polygon> operator()(const std::vector<Polygon>& polygons_m) const;
};

/// A page of a standard size with a drawing at a round scale.
struct Sheet {
  std::string paper;  ///< "A3 landscape"
  Point2 size_mm = Point2::Zero();
  int scale = 100;        ///< 1 : scale
  double turn_rad = 0.0;  ///< of the sheet's right from the building's x axis, counter-clockwise
  Box2 content_mm;        ///< the building's bounding box on paper
  Box2 drawing_mm;        ///< where the building, its dimensions and notes may be
  Box2 strip_mm;          ///< the title block
  PaperTransform to_paper;
};

/// The smallest paper on which the building has a legible scale: A4 at 1:100 or better, A3 at 1:125
/// or better, then A3 up to A1 at 1:250 or better, then A1 at whatever fits.
/// @param building_m in axes that are turned by `turn_rad`; may be empty: an A4 page.
/// @param notes_mm height to keep free above the title block.
/// @param turn_rad which direction of the building lies to the right on the sheet
[[nodiscard]] Sheet choose_sheet(const Box2& building_m, double notes_mm, double turn_rad = 0.0);

/// A point in axes that are turned by `turn_rad`.
[[nodiscard]] Point2 in_turned_axes(const Point2& point_m, double turn_rad);

/// The scale 1 : n of scale rulers (50, 75, 100, 125, 200, 250, 300, 400, 500, 750, 1000 ...) that
/// is at least 1 : `exact`.
[[nodiscard]] int round_scale(double exact);

/// The same with more steps (100, 125, 150, 200, 250, 300, 400 ...), for pictures that fill a
/// given space and have a scale bar.
[[nodiscard]] int fine_scale(double exact);

/// The round length (1, 2 or 5 times a power of ten) closest below `length_m`.
[[nodiscard]] double round_length_m(double length_m);

}  // namespace roomatlas::drawing
