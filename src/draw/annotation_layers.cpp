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

/// The ring around a room's number, its middle at `centre`.
void add_ring(pugi::xml_node node, const Point2& centre, const LabelLine& line) {
  const Point2 half = line.ring_mm() / 2.0;
  const std::string radius = number(half.y());
  add_rectangle(node, {centre - half, centre + half},
                {{"class", "number-ring"},
                 {"rx", radius},
                 {"ry", radius},
                 {"fill", "#ffffff"},
                 {"stroke", kInk},
                 {"stroke-width", "0.18"}});
}

void add_lines(pugi::xml_node node, const RoomLabel& label, bool has_halo) {
  double top = label.center_mm.y();
  for (const LabelLine& line : label.lines) top -= line.pitch_mm() / 2.0;
  for (const LabelLine& line : label.lines) {
    const double pitch = line.pitch_mm();
    const double middle = top + (line.is_number ? line.ring_mm().y() : pitch) / 2.0;
    const Point2 at(label.center_mm.x(), middle + line.size_mm * kCapHeight / 2.0);
    if (line.is_number) add_ring(node, {at.x(), middle}, line);
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
    add_lines(node, label, has_halo || label.is_over_furniture);
  }
}

}  // namespace roomatlas::drawing
