// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet.hpp"
#include "text_extent.hpp"

#include "roomatlas/plan/floor_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace roomatlas::drawing {

struct LabelLine {
  std::string text;
  double size_mm = 2.5;  ///< of the letters
  Weight weight = Weight::normal;
  bool is_number = false;  ///< the room's, in a ring

  /// What the line takes, its ring included.
  [[nodiscard]] double width_mm() const;
  [[nodiscard]] double pitch_mm() const;
  /// Of a number's ring, with straight sides where the number is long.
  [[nodiscard]] Point2 ring_mm() const;
};

/// The text of a room and its place: inside the room, or beside the building on a leader.
struct RoomLabel {
  RoomId room = 0;
  std::vector<LabelLine> lines;
  Point2 center_mm = Point2::Zero();
  Point2 size_mm = Point2::Zero();  ///< before turning
  bool is_turned = false;           ///< reads upwards
  bool shows_area = true;
  bool is_over_furniture = false;      ///< there was no other place
  std::optional<Point2> leader_to_mm;  ///< where the leader ends, in the room

  /// The measured box on paper, after turning.
  [[nodiscard]] Box2 box_mm() const;
};

/// Centre-to-centre distance of lines, as a multiple of the font size.
constexpr double kLineSpacing = 1.25;

/// "12.3 m²"
[[nodiscard]] std::string area_text(double area_m2);

/// A label for each room, in the order of rooms: as large as its room allows, number, name, area
/// and inside measures; then without these; then name and area in one line; then one of them alone;
/// then over furniture, then outside on a leader. Boxes lie inside their rooms, off doors and where
/// possible off furniture, and never overlap; a room for which nothing fits gets no label.
/// @param reserved_mm boxes on paper to keep free, such as the nodes of a graph.
[[nodiscard]] std::vector<RoomLabel> place_labels(const FloorPlan& plan, const Sheet& sheet,
                                                  const std::vector<Box2>& reserved_mm);

}  // namespace roomatlas::drawing
