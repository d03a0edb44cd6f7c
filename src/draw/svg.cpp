// SPDX-License-Identifier: GPL-3.0-or-later
#include "svg.hpp"

#include "roomatlas/draw/markup_text.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

namespace roomatlas::drawing {
namespace {

void append(std::string& path, char command, const Point2& point) {
  path += command;
  path += number(point.x());
  path += ' ';
  path += number(point.y());
}

void append_ring(std::string& path, const Ring& ring) {
  if (ring.empty()) return;
  for (std::size_t i = 0; i < ring.size(); ++i) append(path, i == 0 ? 'M' : 'L', ring[i]);
  path += 'Z';
}

const char* anchor_name(Anchor anchor) {
  switch (anchor) {
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
    case Anchor::start:
      break;
  }
  return "start";
}

/// Names come from files: without what XML cannot hold, of which pugixml would write a reference.
void keep_characters(pugi::xml_node node) {
  const std::string value = node.value();
  if (std::string kept = xml_characters(value); kept != value) node.set_value(kept.c_str());
  for (pugi::xml_attribute& attribute : node.attributes()) {
    const std::string text = attribute.value();
    if (std::string kept = xml_characters(text); kept != text) attribute.set_value(kept.c_str());
  }
  for (const pugi::xml_node& child : node.children()) keep_characters(child);
}

}  // namespace

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "0";
  char text[400];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  std::string written(text, end.ptr);
  const bool is_zero = written.find_first_not_of("-0.") == std::string::npos;
  if (is_zero && written.front() == '-') written.erase(0, 1);
  return written;
}

std::string number(double value) {
  std::string text = fixed(value, 3);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

pugi::xml_node add_page(pugi::xml_document& document, double width_mm, double height_mm,
                        const std::string& title) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node svg = add(document, "svg",
                           {{"xmlns", "http://www.w3.org/2000/svg"},
                            {"xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape"},
                            {"width", number(width_mm) + "mm"},
                            {"height", number(height_mm) + "mm"},
                            {"viewBox", "0 0 " + number(width_mm) + " " + number(height_mm)},
                            {"font-family", kFontFamily}});
  svg.append_child("title").text() = title.c_str();
  add_rectangle(svg, {{0, 0}, {width_mm, height_mm}}, {{"fill", "#ffffff"}});
  return svg;
}

std::string to_text(const pugi::xml_document& document) {
  for (const pugi::xml_node& child : document.children()) keep_characters(child);
  std::ostringstream stream;
  document.save(stream, " ", pugi::format_indent, pugi::encoding_utf8);
  return stream.str();
}

pugi::xml_node add(pugi::xml_node parent, const char* name, const Attributes& attributes) {
  pugi::xml_node node = parent.append_child(name);
  for (const auto& [key, value] : attributes) node.append_attribute(key) = value.c_str();
  return node;
}

pugi::xml_node add_group(pugi::xml_node parent, const char* id, const Attributes& attributes) {
  pugi::xml_node group = add(parent, "g", {{"id", id}});
  for (const auto& [key, value] : attributes) group.append_attribute(key) = value.c_str();
  return group;
}

pugi::xml_node add_layer(pugi::xml_node parent, const char* id, bool is_shown,
                         const Attributes& attributes) {
  pugi::xml_node layer = add(
      parent, "g",
      {{"id", id}, {"class", "layer"}, {"inkscape:groupmode", "layer"}, {"inkscape:label", id}});
  if (!is_shown) layer.append_attribute("display") = "none";
  for (const auto& [key, value] : attributes) layer.append_attribute(key) = value.c_str();
  return layer;
}

void add_title(pugi::xml_node node, const std::string& text) {
  node.append_child("title").text() = text.c_str();
}

pugi::xml_node add_line(pugi::xml_node parent, const Point2& a, const Point2& b,
                        const Attributes& attributes) {
  pugi::xml_node line = add(
      parent, "line",
      {{"x1", number(a.x())}, {"y1", number(a.y())}, {"x2", number(b.x())}, {"y2", number(b.y())}});
  for (const auto& [key, value] : attributes) line.append_attribute(key) = value.c_str();
  return line;
}

pugi::xml_node add_rectangle(pugi::xml_node parent, const Box2& box, const Attributes& attributes) {
  pugi::xml_node rectangle = add(parent, "rect",
                                 {{"x", number(box.min.x())},
                                  {"y", number(box.min.y())},
                                  {"width", number(box.size().x())},
                                  {"height", number(box.size().y())}});
  for (const auto& [key, value] : attributes) rectangle.append_attribute(key) = value.c_str();
  return rectangle;
}

std::string path_of(const std::vector<Polygon>& polygons_mm) {
  std::string path;
  for (const Polygon& polygon : polygons_mm) {
    append_ring(path, polygon.outer);
    for (const Ring& hole : polygon.holes) append_ring(path, hole);
  }
  return path;
}

std::string path_of(const Polyline& line_mm) {
  std::string path;
  for (const Point2& point : line_mm) append(path, path.empty() ? 'M' : 'L', point);
  return path;
}

pugi::xml_node add_text(pugi::xml_node parent, const Point2& at, const std::string& text,
                        const TextStyle& style) {
  pugi::xml_node node = add(parent, "text",
                            {{"x", number(at.x())},
                             {"y", number(at.y())},
                             {"font-size", number(style.size_mm)},
                             {"fill", style.fill}});
  if (style.weight == Weight::bold) node.append_attribute("font-weight") = "bold";
  if (style.anchor != Anchor::start) {
    node.append_attribute("text-anchor") = anchor_name(style.anchor);
  }
  node.text() = text.c_str();
  return node;
}

}  // namespace roomatlas::drawing
