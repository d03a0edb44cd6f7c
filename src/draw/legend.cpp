// SPDX-License-Identifier: GPL-3.0-or-later
#include "legend.hpp"

#include "hatch.hpp"
#include "plan_layers.hpp"
#include "style.hpp"
#include "svg.hpp"
#include "text_extent.hpp"
#include "wall_pieces.hpp"

#include <algorithm>

namespace roomatlas::drawing {
namespace {

// Of a sample, and of the rows.
constexpr double kSwatch_mm = 5.0;
constexpr double kGap_mm = 1.5;
constexpr double kMostPitch_mm = 4.9;
constexpr double kText_mm = 2.4;
constexpr double kMostName_mm = 26.0;  // of a mission; longer ones make all letters small

Point2 at(const Box2& box, double x, double y) {
  return box.min + box.size().cwiseProduct(Point2(x, y));
}

auto swatch(const char* fill, double width_mm) {
  return [=](pugi::xml_node parent, const Box2& box) {
    add_rectangle(parent, box,
                  {{"fill", fill}, {"stroke", kFaintInk}, {"stroke-width", number(width_mm)}});
  };
}

auto line(const char* stroke, const char* dash, double width_mm) {
  return [=](pugi::xml_node parent, const Box2& box) {
    Attributes attributes = {{"stroke", stroke}, {"stroke-width", number(width_mm)}};
    if (dash != nullptr) attributes.emplace_back("stroke-dasharray", dash);
    add_line(parent, at(box, 0.0, 0.5), at(box, 1.0, 0.5), attributes);
  };
}

auto hatched_swatch(double angle_rad, double width_mm) {
  return [=](pugi::xml_node parent, const Box2& box) {
    add_rectangle(parent, box,
                  {{"fill", kFurnitureFill},
                   {"stroke", kFurnitureStroke},
                   {"stroke-width", number(width_mm)}});
    const Ring ring = {at(box, 0, 0), at(box, 1, 0), at(box, 1, 1), at(box, 0, 1)};
    for (const Segment2& stroke : hatched({ring, {}}, angle_rad, kHatchPitch_mm)) {
      add_line(parent, stroke.a, stroke.b,
               {{"stroke", kHatchStroke}, {"stroke-width", number(width_mm)}});
    }
  };
}

/// Two faces of an opening between the ends of a wall.
auto opening(const char* stroke, const char* dash, double width_mm, bool has_panes) {
  return [=](pugi::xml_node parent, const Box2& box) {
    for (const double x : {0.0, 0.8}) {
      add_rectangle(parent, {at(box, x, 0.2), at(box, x + 0.2, 0.8)}, {{"fill", kWallFill}});
    }
    Attributes attributes = {{"stroke", stroke}, {"stroke-width", number(width_mm)}};
    if (dash != nullptr) attributes.emplace_back("stroke-dasharray", dash);
    for (const double y : {0.2, 0.8}) {
      add_line(parent, at(box, 0.2, y), at(box, 0.8, y), attributes);
    }
    for (const double y : {0.4, 0.6}) {
      if (has_panes) add_line(parent, at(box, 0.2, y), at(box, 0.8, y), attributes);
    }
  };
}

auto leaf(const LineWeights& weights) {
  return [=](pugi::xml_node parent, const Box2& box) {
    const Point2 hinge = at(box, 0.25, 1.0);
    const double radius = box.size().y();
    const Point2 tip = hinge - Point2(0.0, radius);
    for (const Segment2& wall : {Segment2{at(box, 0.0, 1.0), hinge},
                                 Segment2{hinge + Point2(radius, 0.0), at(box, 1.0, 1.0)}}) {
      add_line(parent, wall.a, wall.b, {{"stroke", kWallFill}, {"stroke-width", "0.8"}});
    }
    add_line(parent, hinge, tip, {{"stroke", kWallFill}, {"stroke-width", number(weights.cut)}});
    const std::string r = number(radius);
    add(parent, "path",
        {{"fill", "none"},
         {"stroke", kFaintInk},
         {"stroke-width", number(weights.fine)},
         {"d", "M" + number(tip.x()) + " " + number(tip.y()) + "A" + r + " " + r + " 0 0 1 " +
                   number(hinge.x() + radius) + " " + number(hinge.y())}});
  };
}

auto inferred_wall(const LineWeights& weights) {
  return [=](pugi::xml_node parent, const Box2& box) {
    for (const double y : {0.15, 0.85}) {
      add_line(parent, at(box, 0.0, y), at(box, 1.0, y),
               {{"stroke", kInferredStroke},
                {"stroke-width", number(weights.visible)},
                {"stroke-dasharray", kInferredDash}});
    }
  };
}

/// Collects entries for what there is.
class Legend {
 public:
  template <typename Draw>
  void add_if(bool is_there, const std::string& name, Draw draw) {
    if (is_there) entries_.push_back({name, draw});
  }
  [[nodiscard]] std::vector<LegendEntry> entries() && { return std::move(entries_); }

 private:
  std::vector<LegendEntry> entries_;
};

void add_walls(Legend& legend, const FloorPlan& plan, const PlanAnnotations& annotations,
               const LineWeights& weights) {
  const auto has = [&](WallEvidence evidence) {
    return std::any_of(plan.edges.begin(), plan.edges.end(),
                       [&](const PlanEdge& edge) { return edge.evidence == evidence; });
  };
  const bool is_told = !plan.edges.empty();
  legend.add_if(!plan.walls.empty(), is_told ? "wall, measured" : "wall",
                swatch(kWallFill, weights.hatch));
  legend.add_if(!thin_walls(wall_faces(plan.walls), kPartition_m).empty(), "thin wall",
                swatch(kPartitionFill, weights.cut));
  legend.add_if(has(WallEvidence::inferred), "wall, inferred", inferred_wall(weights));
  legend.add_if(is_told ? has(WallEvidence::unexplored) : !annotations.unexplored.empty(),
                "unexplored", line(kUnexploredStroke, kUnexploredDash, 0.35));
}

void add_openings(Legend& legend, const FloorPlan& plan, const LineWeights& weights) {
  const auto has = [&](DoorKind kind, bool has_leaf) {
    return std::any_of(plan.doors.begin(), plan.doors.end(), [&](const PlanDoor& door) {
      return door.kind == kind && door.leaf.has_value() == has_leaf;
    });
  };
  const bool has_leaf = has(DoorKind::door, true);
  legend.add_if(has_leaf, "door, leaf seen", leaf(weights));
  legend.add_if(has(DoorKind::door, false), has_leaf ? "door, no leaf seen" : "door",
                opening(kFaintInk, nullptr, weights.fine, false));
  legend.add_if(has(DoorKind::passage, false) || has(DoorKind::passage, true), "passage",
                opening(kFaintInk, kLintelDash, weights.fine, false));
  legend.add_if(has(DoorKind::window, false) || has(DoorKind::window, true), "window",
                opening(kWallFill, nullptr, weights.visible, true));
}

/// One line, or one for each mission while they fit.
void add_paths(Legend& legend, const PlanAnnotations& annotations, const DrawOptions& options) {
  constexpr std::size_t kMostNamed = 6;
  const std::vector<MissionPath>& missions = annotations.missions;
  if (missions.empty()) {
    legend.add_if(options.show_trajectory, "path", line(kPathStroke, nullptr, 0.35));
    return;
  }
  const std::size_t named = missions.size() <= kMostNamed ? missions.size() : kMostNamed - 1;
  for (std::size_t i = 0; i < named; ++i) {
    const PathStyle style = path_style(i);
    const std::string name = shortened(missions[i].name, kMostName_mm, kText_mm, Weight::normal);
    legend.add_if(options.show_trajectory, name,
                  line(style.stroke, *style.dash == '\0' ? nullptr : style.dash, 0.35));
  }
  if (named == missions.size()) return;
  const PathStyle style = path_style(named);
  legend.add_if(options.show_trajectory,
                "and " + std::to_string(missions.size() - named) + " more paths",
                line(style.stroke, style.dash, 0.35));
}

}  // namespace

std::vector<LegendEntry> legend_of(const FloorPlan& plan, const PlanAnnotations& annotations,
                                   const DrawOptions& options, int scale) {
  const LineWeights weights = line_weights(scale);
  Legend legend;
  for (const RoomKind kind : {RoomKind::room, RoomKind::corridor, RoomKind::hall}) {
    const bool is_there = std::any_of(plan.rooms.begin(), plan.rooms.end(),
                                      [&](const PlanRoom& room) { return room.kind == kind; });
    legend.add_if(is_there, to_string(kind), swatch(tint(kind), weights.hatch));
  }
  add_walls(legend, plan, annotations, weights);
  add_openings(legend, plan, weights);
  const auto has = [&](FurnitureKind kind) {
    return std::any_of(plan.furniture.begin(), plan.furniture.end(),
                       [&](const PlanFurniture& piece) { return piece.kind == kind; });
  };
  legend.add_if(has(FurnitureKind::against_wall), "furniture at walls",
                hatched_swatch(kAgainstWall_rad, weights.hatch));
  legend.add_if(has(FurnitureKind::free_standing), "furniture, free",
                hatched_swatch(kFreeStanding_rad, weights.hatch));
  add_paths(legend, annotations, options);
  legend.add_if(options.show_room_graph, "room graph", line(kGraphStroke, "1.2 0.8", 0.35));
  legend.add_if(options.show_corrections, "correction", line(kCorrectionStroke, nullptr, 0.35));
  legend.add_if(options.show_uncertainty, "95 % sure", line(kUncertaintyStroke, nullptr, 0.35));
  return std::move(legend).entries();
}

void add_legend(pugi::xml_node parent, const Box2& box_mm,
                const std::vector<LegendEntry>& entries) {
  const int count = static_cast<int>(entries.size());
  const double usable_mm = box_mm.size().y() - 5.5;
  double longest = 0.0;  // a millimetre of letters
  for (const LegendEntry& entry : entries) {
    longest = std::max(longest, text_width_mm(entry.name, 1.0, Weight::normal));
  }
  const auto columns_for = [&](double size_mm) {
    return static_cast<int>(box_mm.size().x() / (kSwatch_mm + 2.0 * kGap_mm + longest * size_mm));
  };
  const int columns = std::clamp(columns_for(kText_mm), 2, 3);
  const int rows = std::max(5, (count + columns - 1) / columns);
  const double pitch_mm = std::min(kMostPitch_mm, usable_mm / rows);
  const double column_mm = box_mm.size().x() / columns;
  const double fitting_mm = (column_mm - kSwatch_mm - 2.0 * kGap_mm) / std::max(1.0, longest);
  const double size_mm = std::min({kText_mm, 0.75 * pitch_mm, fitting_mm});
  const double swatch_mm = std::min(2.8, 0.78 * pitch_mm);
  pugi::xml_node group = add_group(parent, "legend");
  for (int i = 0; i < count; ++i) {
    const LegendEntry& entry = entries[static_cast<std::size_t>(i)];
    const int column = i / rows;
    const double x = box_mm.min.x() + column * column_mm;
    const double middle = box_mm.min.y() + 4.7 + (i % rows) * pitch_mm;
    entry.draw(group, {{x, middle - swatch_mm / 2.0}, {x + kSwatch_mm, middle + swatch_mm / 2.0}});
    add_text(group, {x + kSwatch_mm + kGap_mm, middle + size_mm * kCapHeight / 2.0}, entry.name,
             {size_mm, Weight::normal, Anchor::start, kInk});
  }
}

}  // namespace roomatlas::drawing
