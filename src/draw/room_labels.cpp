// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_labels.hpp"

#include "label_space.hpp"
#include "svg.hpp"

#include "roomatlas/draw/dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace roomatlas::drawing {
namespace {

constexpr double kSmallestName_mm = 1.7;  // beside a room; smaller cannot be read on paper
constexpr double kLargestOver_mm = 2.1;   // over furniture
constexpr double kAreaToName = 0.78;      // font sizes ...
constexpr double kExtentToName = 0.66;    // ... but at least:
constexpr double kSmallestExtent_mm = 1.6;
constexpr double kAir_mm = 0.5;   // around the text
constexpr int kMaxNameLines = 3;  // more look like a list

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
    width = std::max(width, line.width_mm());
    height += line.pitch_mm();
  }
  label.size_mm = Point2(width, height) + Point2::Constant(2.0 * kAir_mm);
  return label;
}

/// A room to be labelled, and its inside measures where it has any.
struct Subject {
  const PlanRoom& room;
  std::optional<RoomExtent> extent;

  [[nodiscard]] std::string number() const { return std::to_string(room.id); }
  [[nodiscard]] bool is_named() const { return !room.name.empty() && room.name != number(); }
};

/// Number, name, area and measures, one below the other; no lines where the name has too few words.
RoomLabel tag(const Subject& subject, double name_mm, int name_lines, bool has_extent) {
  std::vector<LabelLine> lines = {{subject.number(), name_mm, Weight::bold, true}};
  if (subject.is_named()) {
    const auto names = broken(subject.room.name, name_lines, name_mm);
    if (names.empty()) return {};
    for (const std::string& text : names) lines.push_back({text, name_mm, Weight::bold});
  } else if (name_lines > 1) {
    return {};
  }
  lines.push_back({area_text(subject.room.area_m2), name_mm * kAreaToName, Weight::normal});
  if (has_extent) {
    const std::string text = fixed(subject.extent->width_m, 2) + "\u2009\u00d7\u2009" +
                             fixed(subject.extent->depth_m, 2);
    lines.push_back({text, std::max(kSmallestExtent_mm, name_mm * kExtentToName), Weight::normal});
  }
  return measured(subject.room.id, std::move(lines));
}

/// A way to write a tag: the size of the name, and whether it reads upwards.
struct Way {
  double name_mm;
  bool is_turned;
};

/// Upright is easier to read than large.
constexpr std::array<Way, 10> kWays = {{{3.5, false},
                                        {3.0, false},
                                        {2.5, false},
                                        {3.5, true},
                                        {3.0, true},
                                        {2.1, false},
                                        {2.5, true},
                                        {1.8, false},
                                        {2.1, true},
                                        {1.8, true}}};

/// The largest name on a drawing of that scale, so that small rooms do not drown in text.
double largest_name_mm(int scale) { return scale <= 100 ? 3.5 : scale <= 150 ? 3.0 : 2.5; }

/// What is tried, best first.
std::vector<RoomLabel> candidates(const Subject& subject, int scale) {
  const PlanRoom& room = subject.room;
  std::vector<RoomLabel> labels;
  const auto add = [&](RoomLabel label, bool is_turned) {
    if (label.lines.empty()) return;
    label.is_turned = is_turned;
    labels.push_back(std::move(label));
  };
  for (const Way& way : kWays) {
    if (way.name_mm > largest_name_mm(scale)) continue;
    for (const bool has_extent : {true, false}) {
      if (has_extent && !subject.extent) continue;
      for (int lines = 1; lines <= kMaxNameLines; ++lines) {
        add(tag(subject, way.name_mm, lines, has_extent), way.is_turned);
      }
    }
  }
  const double last_mm = kWays.back().name_mm;
  const std::string number = subject.is_named() ? subject.number() + "  " : "";
  const RoomLabel one_line = measured(
      room.id, {{number + room.name + "  " + area_text(room.area_m2), last_mm, Weight::bold}});
  for (const bool is_turned : {false, true}) add(one_line, is_turned);
  const auto add_number = [&](double size_mm, bool has_ring, bool is_turned) {
    RoomLabel alone = measured(room.id, {{subject.number(), size_mm, Weight::bold, has_ring}});
    alone.shows_area = false;
    add(std::move(alone), is_turned);
  };
  for (const double size_mm : {2.5, last_mm}) {
    for (const bool is_turned : {false, true}) add_number(size_mm, true, is_turned);
  }
  for (const bool is_turned : {false, true}) add_number(kSmallestName_mm, false, is_turned);
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
  const Point2& origin = ring.front();
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

/// Inside the room, off furniture if that can be.
std::optional<RoomLabel> placed_inside(const Subject& subject, const Sheet& sheet,
                                       const LabelSpace& space) {
  const PlanRoom& room = subject.room;
  const Polygon room_mm = sheet.to_paper({room.parts.front()}).front();
  const Point2 centre_mm = visual_centre(room_mm, sheet.to_paper(room.label_point));
  const std::vector<Point2> positions_mm = positions(room_mm, centre_mm);
  for (const bool over_furniture : {false, true}) {
    const LabelSpace here = space.within(bounds(room_mm.outer), !over_furniture);
    if (over_furniture && !space.has_furniture(bounds(room_mm.outer))) break;
    for (RoomLabel& label : candidates(subject, sheet.scale)) {
      const bool is_large = label.lines.front().size_mm > kLargestOver_mm;
      if (over_furniture && is_large) continue;  // it would hide what it lies on
      label.is_over_furniture = over_furniture;
      if (place_inside(room_mm, positions_mm, here, label)) return label;
    }
  }
  return std::nullopt;
}

}  // namespace

double LabelLine::width_mm() const {
  return is_number ? ring_mm().x() : text_width_mm(text, size_mm, weight);
}

double LabelLine::pitch_mm() const {
  return is_number ? ring_mm().y() + 0.35 * size_mm : size_mm * kLineSpacing;
}

Point2 LabelLine::ring_mm() const {
  const double height = 1.75 * size_mm;
  return {std::max(height, text_width_mm(text, size_mm, weight) + 0.8 * size_mm), height};
}

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
  const double turn_rad = sheet.turn_rad;
  for (const PlanRoom& room : plan.rooms) {
    if (room.parts.empty()) continue;
    const auto label = placed_inside({room, extent_of(room, turn_rad)}, sheet, space);
    if (label) {
      keep(*label);
    } else {
      homeless.push_back(&room);
    }
  }
  for (const PlanRoom* room : homeless) {
    RoomLabel label = tag({*room, {}}, kWays.back().name_mm, 1, false);
    if (place_outside(sheet.to_paper(room->label_point), sheet, space, label)) keep(label);
  }
  return placed;
}

}  // namespace roomatlas::drawing
