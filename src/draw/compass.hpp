// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/core/geometry.hpp"

#include <pugixml.hpp>

#include <optional>

namespace roomatlas::drawing {

/// The widest and highest that `add_compass` draws, from its centre.
constexpr double kCompassRadius_mm = 9.0;

/// An arrow to the north, or the axes of the building's coordinates where north is not known.
/// @param north_deg clockwise from the building's y axis
/// @param turn_rad of the sheet's right from the building's x axis, counter-clockwise
void add_compass(pugi::xml_node parent, const Point2& centre_mm, std::optional<double> north_deg,
                 double turn_rad);

}  // namespace roomatlas::drawing
