// SPDX-License-Identifier: GPL-3.0-or-later
#include "compass.hpp"

#include "style.hpp"
#include "svg.hpp"

#include <cmath>

namespace roomatlas::drawing {
namespace {

constexpr double kText_mm = 2.6;  // height of letters

/// Text whose middle is at `centre`.
void add_letter(pugi::xml_node parent, const Point2& centre, const char* letter) {
  add_text(parent, centre + Point2(0.0, kText_mm * kCapHeight / 2.0), letter,
           {kText_mm, Weight::bold, Anchor::middle, kInk});
}

/// Half black and half white, as on maps.
void add_north(pugi::xml_node parent, const Point2& centre, double north_deg) {
  // From the middle.
  constexpr double kTip_mm = 5.2;
  constexpr double kTail_mm = 4.2;
  constexpr double kHalfWidth_mm = 2.2;
  constexpr double kNotch_mm = 2.4;
  constexpr double kLetter_mm = 7.3;
  const double north_rad = radians(north_deg);
  const Point2 up(std::sin(north_rad), -std::cos(north_rad));
  const Point2 right(-up.y(), up.x());
  const Point2 tip = centre + kTip_mm * up;
  const Point2 notch = centre - kNotch_mm * up;
  for (const double side : {-1.0, 1.0}) {
    const Ring half = {tip, notch, centre - kTail_mm * up + side * kHalfWidth_mm * right};
    add(parent, "path",
        {{"d", path_of({{half, {}}})},
         {"fill", side < 0.0 ? kInk : "#ffffff"},
         {"stroke", kInk},
         {"stroke-width", kHairline_mm},
         {"stroke-linejoin", "round"}});
  }
  add_letter(parent, centre + kLetter_mm * up, "N");
}

void add_axis(pugi::xml_node parent, const Point2& origin, const Point2& along,
              const char* letter) {
  // From the corner of both axes.
  constexpr double kLength_mm = 9.0;
  constexpr double kLetter_mm = 11.2;
  const Point2 tip = origin + kLength_mm * along;
  const Point2 side(-0.6 * along.y(), 0.6 * along.x());
  const Polyline arrow = {origin, tip, tip - 1.6 * along + side, tip, tip - 1.6 * along - side};
  add(parent, "path",
      {{"d", path_of(arrow)},
       {"fill", "none"},
       {"stroke", kInk},
       {"stroke-width", kThin_mm},
       {"stroke-linejoin", "round"}});
  add_letter(parent, origin + kLetter_mm * along, letter);
}

}  // namespace

void add_compass(pugi::xml_node parent, const Point2& centre_mm, std::optional<double> north_deg,
                 double turn_rad) {
  pugi::xml_node group = add_group(parent, north_deg ? "north" : "axes");
  if (north_deg) {
    add_north(group, centre_mm, *north_deg + degrees(turn_rad));
    return;
  }
  const Point2 x(std::cos(turn_rad), std::sin(turn_rad));  // y is down on paper
  const Point2 y(x.y(), -x.x());
  const Point2 origin = centre_mm - 5.5 * (x + y);
  add_axis(group, origin, x, "x");
  add_axis(group, origin, y, "y");
}

}  // namespace roomatlas::drawing
