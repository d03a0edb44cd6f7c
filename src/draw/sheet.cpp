// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace roomatlas::drawing {
namespace {

constexpr double kStripGap_mm = 2.0;        // between the drawing and the title block
constexpr int kLargestScale = 50;           // 1:50 shows all that a robot can measure
constexpr int kSmallestScale = 1000000000;  // beyond any building

struct Paper {
  const char* name;
  double width_mm;
  double height_mm;
};

/// ISO 216, the smallest first.
constexpr std::array<Paper, 8> kPapers = {{{"A4 landscape", 297, 210},
                                           {"A4 portrait", 210, 297},
                                           {"A3 landscape", 420, 297},
                                           {"A3 portrait", 297, 420},
                                           {"A2 landscape", 594, 420},
                                           {"A2 portrait", 420, 594},
                                           {"A1 landscape", 841, 594},
                                           {"A1 portrait", 594, 841}}};

/// @param steps ascending, times powers of ten.
int scale_among(std::initializer_list<double> steps, double exact) {
  for (int decade = 10; decade < kSmallestScale / 20; decade *= 10) {
    for (const double step : steps) {
      const int scale = static_cast<int>(step * decade);
      if (scale >= kLargestScale && scale >= exact) return scale;
    }
  }
  return kSmallestScale;
}

/// Where the building itself may be.
Box2 building_area(const Paper& paper, double notes_mm) {
  const double bottom = paper.height_mm - kMargin_mm - kStrip_mm - kStripGap_mm - notes_mm;
  return {{kMargin_mm + kDimension_mm, kMargin_mm + kPadding_mm},
          {paper.width_mm - kMargin_mm - kPadding_mm, bottom - kDimension_mm}};
}

/// The scale at which the building fits the paper.
int fitting_scale(const Paper& paper, const Point2& building_m, double notes_mm) {
  const Point2 area_mm = building_area(paper, notes_mm).size();
  const Point2 exact = (building_m * kMillimetres).cwiseQuotient(area_mm);
  return round_scale(exact.maxCoeff());
}

/// Of a landscape and a portrait sheet the better one.
const Paper& better_way(std::size_t landscape, const Point2& building_m, double notes_mm) {
  const Paper& lying = kPapers[landscape];
  const Paper& standing = kPapers[landscape + 1];
  const bool stands =
      fitting_scale(standing, building_m, notes_mm) < fitting_scale(lying, building_m, notes_mm);
  return stands ? standing : lying;
}

const Paper& choose_paper(const Point2& building_m, double notes_mm) {
  struct Wish {
    std::size_t landscape;
    int scale;
  };
  for (const Wish wish : {Wish{0, 100}, Wish{2, 125}, Wish{2, 250}, Wish{4, 250}, Wish{6, 250}}) {
    const Paper& paper = better_way(wish.landscape, building_m, notes_mm);
    if (fitting_scale(paper, building_m, notes_mm) <= wish.scale) return paper;
  }
  return better_way(6, building_m, notes_mm);
}

}  // namespace

Point2 PaperTransform::operator()(const Point2& point_m) const {
  return offset_mm + mm_per_m * direction(point_m);
}

Point2 PaperTransform::direction(const Point2& building) const {
  return {right.dot(building), -cross(right, building)};
}

Point2 in_turned_axes(const Point2& point_m, double turn_rad) {
  const Point2 right = direction(turn_rad);
  return {right.dot(point_m), cross(right, point_m)};
}

Polyline PaperTransform::operator()(const Polyline& line_m) const {
  Polyline line_mm;
  line_mm.reserve(line_m.size());
  for (const Point2& point : line_m) line_mm.push_back((*this)(point));
  return line_mm;
}

std::vector<Polygon> PaperTransform::operator()(const std::vector<Polygon>& polygons_m) const {
  std::vector<Polygon> polygons_mm;
  for (const Polygon& polygon : polygons_m) {
    polygons_mm.push_back({(*this)(polygon.outer), {}});
    for (const Ring& hole : polygon.holes) polygons_mm.back().holes.push_back((*this)(hole));
  }
  return polygons_mm;
}

int round_scale(double exact) {
  return scale_among({1.0, 1.25, 2.0, 2.5, 3.0, 4.0, 5.0, 7.5}, exact);
}

int fine_scale(double exact) {
  return scale_among({2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.5, 15.0}, exact);
}

double round_length_m(double length_m) {
  if (!(length_m > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(length_m)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= length_m) return step * decade;
  }
  return decade;
}

Sheet choose_sheet(const Box2& building_m, double notes_mm, double turn_rad) {
  const Point2 size_m = building_m.size();
  const Paper& paper = choose_paper(size_m, notes_mm);
  Sheet sheet;
  sheet.paper = paper.name;
  sheet.size_mm = {paper.width_mm, paper.height_mm};
  sheet.scale = fitting_scale(paper, size_m, notes_mm);
  sheet.strip_mm = {{kMargin_mm, paper.height_mm - kMargin_mm - kStrip_mm},
                    {paper.width_mm - kMargin_mm, paper.height_mm - kMargin_mm}};
  sheet.drawing_mm = {{kMargin_mm, kMargin_mm},
                      {sheet.strip_mm.max.x(), sheet.strip_mm.min.y() - kStripGap_mm}};
  const Box2 area = building_area(paper, notes_mm);
  const Point2 centre_mm = (area.min + area.max) / 2.0;
  const Point2 centre_m =
      building_m.empty() ? Point2::Zero() : Point2((building_m.min + building_m.max) / 2.0);
  sheet.turn_rad = turn_rad;
  if (turn_rad != 0.0) sheet.to_paper.right = direction(turn_rad);
  sheet.to_paper.mm_per_m = kMillimetres / sheet.scale;
  sheet.to_paper.offset_mm = {centre_mm.x() - sheet.to_paper.mm_per_m * centre_m.x(),
                              centre_mm.y() + sheet.to_paper.mm_per_m * centre_m.y()};
  const Point2 half_mm = size_m * sheet.to_paper.mm_per_m / 2.0;
  sheet.content_mm = {centre_mm - half_mm, centre_mm + half_mm};
  return sheet;
}

}  // namespace roomatlas::drawing
