// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"

#include <utility>

namespace roomatlas::drawing {

namespace {

/// A white copy of the label's text, a little fatter. It lies beneath plain text, since text that
/// is itself stroked would become outlines in a PDF.
void add_halo(pugi::xml_node node, const Point2& at, const LabelLine& line) {
  pugi::xml_node halo =
      add_text(node, at, line.text, {line.size_mm, line.weight, Anchor::middle, "#ffffff"});
  for (const auto& [key, value] : {std::pair{"class", "halo"},
                                   {"aria-hidden", "true"},
                                   {"stroke", "#ffffff"},
                                   {"stroke-width", "0.7"},
                                   {"stroke-linejoin", "round"}}) {
    halo.append_attribute(key) = value;
  }
}

void add_leader(pugi::xml_node node, const RoomLabel& label) {
  add_line(node, label.center_mm, *label.leader_to_mm,
           {{"stroke", kFaintInk}, {"stroke-width", kHairline_mm}});
  add_rectangle(node, label.box_mm(), {{"fill", "#ffffff"}});
  add(node, "circle",
      {{"cx", number(label.leader_to_mm->x())},
       {"cy", number(label.leader_to_mm->y())},
       {"r", "0.4"},
       {"fill", kFaintInk}});
}

void add_lines(pugi::xml_node node, const RoomLabel& label, bool has_halo) {
  double top = label.center_mm.y();
  for (const LabelLine& line : label.lines) top -= line.size_mm * kLineSpacing / 2.0;
  for (const LabelLine& line : label.lines) {
    const double pitch = line.size_mm * kLineSpacing;
    const double baseline = top + pitch / 2.0 + line.size_mm * kCapHeight / 2.0;
    const Point2 at(label.center_mm.x(), baseline);
    if (has_halo) add_halo(node, at, line);
    add_text(node, at, line.text, {line.size_mm, line.weight, Anchor::middle, kInk});
    top += pitch;
  }
}

}  // namespace

void add_labels(pugi::xml_node svg, const std::vector<RoomLabel>& labels, bool has_halo) {
  pugi::xml_node group = add_layer(svg, "labels");
  for (const RoomLabel& label : labels) {
    pugi::xml_node node = add(group, "g", {{"data-room", std::to_string(label.room)}});
    if (label.leader_to_mm) {
      node.append_attribute("class") = "leader";
      add_leader(node, label);
    }
    if (label.is_turned) {
      const Point2& center = label.center_mm;
      const std::string turn = "rotate(-90 " + number(center.x()) + " " + number(center.y()) + ")";
      node.append_attribute("transform") = turn.c_str();
    }
    add_lines(node, label, has_halo);
  }
}

void add_dimensions(pugi::xml_node svg, const Box2& building_m, const Sheet& sheet) {
  pugi::xml_node group =
      add_layer(svg, "dimensions", true, {{"stroke", kFaintInk}, {"stroke-width", kHairline_mm}});
  const Box2& box = sheet.content_mm;
  const double below = box.max.y() + 7.0;
  const double beside = box.min.x() - 7.0;
  const Point2 tick(0.9, -0.9);
  const auto dimension = [&](const Point2& a, const Point2& b, const Point2& overshoot) {
    add_line(group, a - overshoot, b + overshoot);
    for (const Point2& end : {a, b}) {
      add_line(group, end - tick, end + tick, {{"stroke-width", kFrame_mm}});
    }
  };
  const TextStyle style{2.4, Weight::normal, Anchor::middle, kFaintInk};
  const auto add_measure = [&](const Point2& at, double length_m) {
    pugi::xml_node text = add_text(group, at, fixed(length_m, 2) + "\u00a0m", style);
    text.append_attribute("stroke") = "none";
    return text;
  };
  for (const double x : {box.min.x(), box.max.x()}) {
    add_line(group, {x, box.max.y() + 2.0}, {x, below + 1.5});
  }
  dimension({box.min.x(), below}, {box.max.x(), below}, {1.5, 0.0});
  add_measure({(box.min.x() + box.max.x()) / 2.0, below - 1.0}, building_m.size().x());
  for (const double y : {box.min.y(), box.max.y()}) {
    add_line(group, {box.min.x() - 2.0, y}, {beside - 1.5, y});
  }
  dimension({beside, box.min.y()}, {beside, box.max.y()}, {0.0, 1.5});
  const Point2 at(beside - 1.0, (box.min.y() + box.max.y()) / 2.0);
  const std::string turn = "rotate(-90 " + number(at.x()) + " " + number(at.y()) + ")";
  add_measure(at, building_m.size().y()).append_attribute("transform") = turn.c_str();
}

}  // namespace roomatlas::drawing
