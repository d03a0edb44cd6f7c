// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "text_extent.hpp"

#include "roomatlas/core/geometry.hpp"

#include <pugixml.hpp>

#include <string>
#include <utility>
#include <vector>

/// Small verbs that write SVG. Private; all coordinates are millimetres on paper, y down.
namespace roomatlas::drawing {

using Attributes = std::vector<std::pair<const char*, std::string>>;

/// At most three decimals, no trailing zeros, never "-0": the same bytes everywhere.
[[nodiscard]] std::string number(double value);
/// A fixed number of decimals, for measures that people read.
[[nodiscard]] std::string fixed(double value, int decimals);

/// An empty document of the given paper size, on white.
[[nodiscard]] pugi::xml_node add_page(pugi::xml_document& document, double width_mm,
                                      double height_mm, const std::string& title);
[[nodiscard]] std::string to_text(const pugi::xml_document& document);

pugi::xml_node add(pugi::xml_node parent, const char* name, const Attributes& attributes);
pugi::xml_node add_group(pugi::xml_node parent, const char* id, const Attributes& attributes = {});
/// A layer of the drawing: a group of class `layer`, which Inkscape lists by its name.
/// @param is_shown otherwise the layer is there, but not displayed
pugi::xml_node add_layer(pugi::xml_node parent, const char* id, bool is_shown = true,
                         const Attributes& attributes = {});
/// What a pointer that rests on the node is told, and a screen reader says.
void add_title(pugi::xml_node node, const std::string& text);
pugi::xml_node add_line(pugi::xml_node parent, const Point2& a, const Point2& b,
                        const Attributes& attributes = {});
pugi::xml_node add_rectangle(pugi::xml_node parent, const Box2& box, const Attributes& attributes);

/// `M ... Z` of all rings; to be filled with the even-odd rule.
[[nodiscard]] std::string path_of(const std::vector<Polygon>& polygons_mm);
/// `M ... L ...`, without the closing line.
[[nodiscard]] std::string path_of(const Polyline& line_mm);

enum class Anchor { start, middle, end };

struct TextStyle {
  double size_mm = 2.5;  ///< of letters
  Weight weight = Weight::normal;
  Anchor anchor = Anchor::start;
  std::string fill = "#1f2933";
};

/// Text whose baseline starts, is centred or ends at `at`.
pugi::xml_node add_text(pugi::xml_node parent, const Point2& at, const std::string& text,
                        const TextStyle& style);

}  // namespace roomatlas::drawing
