// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_labels.hpp"

#include "label_space.hpp"
#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace roomatlas::drawing {
namespace {

constexpr std::array<double, 5> kNameSizes_mm = {3.6, 3.1, 2.6, 2.2, 1.9};  // the largest that fits
constexpr double kSmallestName_mm = 1.7;  // beside a room; smaller cannot be read on paper
constexpr double kAreaToName = 0.78;      // font sizes
constexpr double kAir_mm = 0.5;           // around the text
constexpr int kMaxNameLines = 3;          // more look like a list

/// The widest line when `words` are broken into `count` lines as evenly as a greedy fill can.
std::vector<std::string> broken(const std::string& name, int count, double size_mm) {
  if (count == 1) return {name};
  std::vector<std::string> words;
  std::istringstream stream(name);
  for (std::string word; stream >> word;) words.push_back(word);
  if (static_cast<int>(words.size()) < count) return {};
  const double target_mm = text_width_mm(name, size_mm, Weight::bold) / count;
  std::vector<std::string> lines(1);
  for (const std::string& word : words) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    const bool is_full = !lines.back().empty() && static_cast<int>(lines.size()) < count &&
                         text_width_mm(longer, size_mm, Weight::bold) > 1.15 * target_mm;
    if (is_full) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

RoomLabel measured(RoomId room, std::vector<LabelLine> lines) {
  RoomLabel label;
  label.room = room;
  label.lines = std::move(lines);
  double height = 0.0;
  double width = 0.0;
  for (const LabelLine& line : label.lines) {
    width = std::max(width, text_width_mm(line.text, line.size_mm, line.weight));
    height += line.size_mm * kLineSpacing;
  }
  label.size_mm = Point2(width, height) + Point2::Constant(2.0 * kAir_mm);
  return label;
}

RoomLabel name_over_area(const PlanRoom& room, double name_mm, int name_lines) {
  std::vector<LabelLine> lines;
  for (const std::string& text : broken(room.name, name_lines, name_mm)) {
    lines.push_back({text, name_mm, Weight::bold});
  }
  if (lines.empty()) return {};
  lines.push_back({area_text(room.area_m2), name_mm * kAreaToName, Weight::normal});
  return measured(room.id, std::move(lines));
}

/// What is tried, best first.
std::vector<RoomLabel> candidates(const PlanRoom& room) {
  std::vector<RoomLabel> labels;
  const auto add_both_ways = [&](RoomLabel label) {
    if (label.lines.empty()) return;
    labels.push_back(label);
    label.is_turned = true;
    labels.push_back(std::move(label));
  };
  for (const double size_mm : kNameSizes_mm) {
    for (int lines = 1; lines <= kMaxNameLines; ++lines) {
      add_both_ways(name_over_area(room, size_mm, lines));
    }
  }
  const double last_mm = kNameSizes_mm.back();
  add_both_ways(
      measured(room.id, {{room.name + "  " + area_text(room.area_m2), last_mm, Weight::bold}}));
  for (const double size_mm : {kNameSizes_mm[2], last_mm, kSmallestName_mm}) {
    RoomLabel name_only = measured(room.id, {{room.name, size_mm, Weight::bold}});
    name_only.shows_area = false;
    add_both_ways(std::move(name_only));
  }
  return labels;
}

double clearance(const Polygon& polygon, const Point2& point) {
  double nearest = distance_to_boundary(polygon.outer, point);
  for (const Ring& hole : polygon.holes) {
    nearest = std::min(nearest, distance_to_boundary(hole, point));
  }
  return nearest;
}

Point2 centroid(const Ring& ring) {
  Point2 sum = Point2::Zero();
  double doubled_area = 0.0;
  const Point2 origin = ring.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - origin;
    const Point2 b = ring[(i + 1) % ring.size()] - origin;
    sum += cross(a, b) * (a + b);
    doubled_area += cross(a, b);
  }
  return doubled_area == 0.0 ? origin : Point2(origin + sum / (3.0 * doubled_area));
}

/// The eye expects a label in the middle. The centre of the largest circle, which may be anywhere
/// along a rectangle, is the better place only where the centroid is near a wall or outside.
Point2 visual_centre(const Polygon& room_mm, const Point2& label_point_mm) {
  constexpr double kCloseToBest = 0.7;  // of the best clearance: less puts labels on walls
  const Point2 middle = centroid(room_mm.outer);
  const bool is_good =
      contains(room_mm, middle) &&
      clearance(room_mm, middle) >= kCloseToBest * clearance(room_mm, label_point_mm);
  return is_good ? middle : label_point_mm;
}

/// Positions in the room to try, from `start_mm` outwards.
std::vector<Point2> positions(const Polygon& room_mm, const Point2& start_mm) {
  constexpr int kSteps = 24;  // across the room, each way
  const Box2 box = bounds(room_mm.outer);
  std::vector<Point2> found;
  for (int i = 1; i < kSteps; ++i) {
    for (int j = 1; j < kSteps; ++j) {
      const Point2 share(static_cast<double>(i) / kSteps, static_cast<double>(j) / kSteps);
      found.emplace_back(box.min + box.size().cwiseProduct(share));
    }
  }
  std::stable_sort(found.begin(), found.end(), [&](const Point2& a, const Point2& b) {
    return (a - start_mm).squaredNorm() < (b - start_mm).squaredNorm();
  });
  found.insert(found.begin(), start_mm);
  return found;
}

bool place_inside(const Polygon& room_mm, const std::vector<Point2>& positions_mm,
                  const LabelSpace& space, RoomLabel& label) {
  const Point2 room_size = bounds(room_mm.outer).size();
  const Point2 box = label.box_mm().size();
  if (box.x() > room_size.x() || box.y() > room_size.y()) return false;
  for (const Point2& position : positions_mm) {
    label.center_mm = position;
    if (space.is_free(label.box_mm()) && is_inside(room_mm, label.box_mm())) return true;
  }
  return false;
}

/// Looks for room outside of the building on rings of growing radius.
bool place_outside(const Point2& label_point_mm, const Sheet& sheet, const LabelSpace& space,
                   RoomLabel& label) {
  constexpr double kFarthest_mm = 120.0;  // a longer leader cannot be followed
  constexpr int kDirections = 32;         // tried on each ring
  for (double radius = 4.0; radius < kFarthest_mm; radius += 2.0) {
    for (int i = 0; i < kDirections; ++i) {
      label.center_mm = label_point_mm + radius * direction(2.0 * kPi * i / kDirections);
      const Box2 box = label.box_mm();
      const bool is_on_sheet = (box.min.array() >= sheet.drawing_mm.min.array()).all() &&
                               (box.max.array() <= sheet.drawing_mm.max.array()).all();
      if (is_on_sheet && space.is_free(box) && space.is_outside_building(box)) {
        label.leader_to_mm = label_point_mm;
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Box2 RoomLabel::box_mm() const {
  const Point2 half = (is_turned ? Point2(size_mm.y(), size_mm.x()) : size_mm) / 2.0;
  return {center_mm - half, center_mm + half};
}

std::string area_text(double area_m2) {
  return fixed(area_m2, area_m2 < 999.95 ? 1 : 0) + "\u00a0m\u00b2";
}

std::vector<RoomLabel> place_labels(const FloorPlan& plan, const Sheet& sheet,
                                    const std::vector<Box2>& reserved_mm) {
  LabelSpace space(plan, sheet);
  for (const Box2& box : reserved_mm) space.occupy(box);
  std::vector<RoomLabel> placed;
  std::vector<const PlanRoom*> homeless;
  const auto keep = [&](const RoomLabel& label) {
    space.occupy(label.box_mm());
    placed.push_back(label);
  };
  for (const PlanRoom& room : plan.rooms) {
    if (room.parts.empty()) continue;
    const Polygon room_mm = sheet.to_paper({room.parts.front()}).front();
    const Point2 centre_mm = visual_centre(room_mm, sheet.to_paper(room.label_point));
    const std::vector<Point2> positions_mm = positions(room_mm, centre_mm);
    bool is_placed = false;
    for (RoomLabel& label : candidates(room)) {
      if (!place_inside(room_mm, positions_mm, space, label)) continue;
      keep(label);
      is_placed = true;
      break;
    }
    if (!is_placed) homeless.push_back(&room);
  }
  for (const PlanRoom* room : homeless) {
    RoomLabel label = name_over_area(*room, kNameSizes_mm.back(), 1);
    if (place_outside(sheet.to_paper(room->label_point), sheet, space, label)) keep(label);
  }
  return placed;
}

}  // namespace roomatlas::drawing
