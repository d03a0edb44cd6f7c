// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/ifc.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ifc_model.hpp"
#include "roomatlas/plan/door_keys.hpp"
#include "roomatlas/planar/union.hpp"
#include "wall_segments.hpp"

namespace roomatlas {
namespace {

using io::IfcFrame;
using io::IfcModel;
using io::WallSegment;
using namespace io::step;

// Heights that no robot on the floor measures.
constexpr double kDoorHead_m = 2.1;
constexpr double kSill_m = 0.9;
constexpr double kFurniture_m = 0.75;
constexpr double kPanel_m = 0.04;        // thickness of doors and windows
constexpr double kDoorwayDepth_m = 0.1;  // of a door in a wall without thickness
constexpr double kBeyondWall_m = 0.05;   // that an opening reaches out of its wall
constexpr double kLeastVoid_m2 = 1e-3;   // of a wall's plan: less is no hole

/// Degrees as IfcCompoundPlaneAngleMeasure: degrees, minutes, seconds, millionths, all of one sign.
Value angle(double value_deg) {
  const auto millionths = std::llround(std::abs(value_deg) * 3600.0 * 1e6);
  const long long sign = value_deg < 0.0 ? -1 : 1;
  std::vector<Value> parts;
  for (const long long part : {millionths / 3'600'000'000, millionths / 60'000'000 % 60,
                               millionths / 1'000'000 % 60, millionths % 1'000'000}) {
    parts.push_back(std::to_string(sign * part));
  }
  return list(parts);
}

Point2 north_of(const IfcOptions& options) {
  const double heading_rad = options.on_earth ? radians(options.on_earth->heading_deg) : 0.0;
  return {-std::sin(heading_rad), std::cos(heading_rad)};
}

std::string millimetres(const Point2& point) {
  return std::to_string(std::llround(1000.0 * point.x())) + "," +
         std::to_string(std::llround(1000.0 * point.y()));
}

/// A door's hole in a frame whose x runs from jamb to jamb and whose y is the way that its leaf
/// swings, where that is known.
struct Hole {
  Pose2 building_from_hole;
  Box2 box;  ///< in that frame; y of the wall's faces
  double from_m = 0.0;
  double height_m = 0.0;
  const char* operation = "NOTDEFINED";  ///< IfcDoorTypeOperationEnum
};

Hole hole_of(const PlanDoor& door, double storey_height_m) {
  Segment2 jambs = door.jambs;
  Hole hole;
  if (door.leaf && door.kind == DoorKind::door) {
    const bool swings_left = cross(jambs.b - jambs.a, door.leaf->b - jambs.a) >= 0.0;
    if (!swings_left) std::swap(jambs.a, jambs.b);
    const bool hinged_at_a = (door.leaf->a - jambs.a).norm() <= (door.leaf->a - jambs.b).norm();
    hole.operation = hinged_at_a ? "SINGLE_SWING_LEFT" : "SINGLE_SWING_RIGHT";
  }
  const Point2 along = jambs.b - jambs.a;
  hole.building_from_hole = {jambs.a.x(), jambs.a.y(), std::atan2(along.y(), along.x())};
  hole.box.extend({0.0, -kDoorwayDepth_m / 2.0});
  hole.box.extend({along.norm(), kDoorwayDepth_m / 2.0});
  if (door.opening.size() > 2) {
    double low_m = 0.0;
    double high_m = 0.0;
    for (const Point2& corner : door.opening) {
      const double across_m = (inverse(hole.building_from_hole) * corner).y();
      low_m = std::min(low_m, across_m);
      high_m = std::max(high_m, across_m);
    }
    hole.box.min.y() = low_m;
    hole.box.max.y() = high_m;
  }
  hole.from_m = door.kind == DoorKind::window ? kSill_m : 0.0;
  hole.height_m = std::min(kDoorHead_m, storey_height_m) - hole.from_m;
  return hole;
}

class Building {
 public:
  Building(const FloorPlan& plan, const IfcOptions& options)
      : plan_(plan),
        options_(options),
        segments_(io::wall_segments(plan)),
        model_(options.building, north_of(options)) {}

  std::string step() {
    add_structure();
    add_spaces();
    add_walls();
    add_doors();
    add_furniture();
    relate();
    const std::string date = options_.date.empty() ? "1970-01-01" : options_.date;
    return model_.file().finish("IFC4", "ViewDefinition [DesignTransferView_V1.0]", "plan.ifc",
                                date + "T00:00:00");
  }

 private:
  void add_structure() {
    const std::string title = plan_.title.empty() ? "Building" : plan_.title;
    const IfcFrame ground = model_.frame(nullptr, {}, 0.0);
    const IfcFrame house = model_.frame(&ground, {}, 0.0);
    storey_ = model_.frame(&house, {}, 0.0);
    const Value project =
        model_.root("IFCPROJECT", "project", title,
                    {kNone, kNone, kNone, kNone, list({model_.context()}), model_.units()});
    const auto& earth = options_.on_earth;
    const Value site =
        model_.root("IFCSITE", "site", title,
                    {kNone, kNone, ground.placement, kNone, kNone, word("ELEMENT"),
                     earth ? angle(earth->latitude_deg) : kNone,
                     earth ? angle(earth->longitude_deg) : kNone, kNone, kNone, kNone});
    const Value building =
        model_.root("IFCBUILDING", "building", title,
                    {text("Heights are assumed: they were not measured"), kNone, house.placement,
                     kNone, kNone, word("ELEMENT"), kNone, kNone, kNone});
    storey_entity_ =
        model_.root("IFCBUILDINGSTOREY", "storey", "Level 0",
                    {kNone, kNone, storey_.placement, kNone, kNone, word("ELEMENT"), real(0.0)});
    aggregate("project", project, {site});
    aggregate("site", site, {building});
    aggregate("building", building, {storey_entity_});
  }

  void aggregate(const std::string& thing, const Value& whole, const std::vector<Value>& parts) {
    if (parts.empty()) return;
    model_.root("IFCRELAGGREGATES", thing, "", {kNone, whole, list(parts)});
  }

  void add_spaces() {
    for (const PlanRoom& room : plan_.rooms) {
      const std::string thing = std::to_string(room.id);
      const IfcFrame frame = model_.frame(&storey_, {}, 0.0);
      std::vector<Value> solids;
      for (const Polygon& part : room.parts) {
        solids.push_back(model_.extrusion(frame, part, options_.storey_height_m));
      }
      const Value shape = solids.empty() ? Value(kNone) : model_.shape(solids);
      spaces_.push_back(model_.root("IFCSPACE", thing, thing,
                                    {kNone, text(to_string(room.kind)), frame.placement, shape,
                                     text(room.name), word("ELEMENT"), word("INTERNAL"), kNone}));
      add_quantities(thing, spaces_.back(), room.area_m2);
    }
  }

  void add_quantities(const std::string& thing, const Value& space, double area_m2) {
    const auto quantity = [&](const char* type, const char* name, double value) {
      return model_.file().add(type, {text(name), kNone, kNone, real(value), kNone});
    };
    const double height_m = options_.storey_height_m;
    const Value quantities =
        model_.root("IFCELEMENTQUANTITY", thing, "Qto_SpaceBaseQuantities",
                    {kNone, kNone,
                     list({quantity("IFCQUANTITYLENGTH", "Height", height_m),
                           quantity("IFCQUANTITYAREA", "NetFloorArea", area_m2),
                           quantity("IFCQUANTITYVOLUME", "NetVolume", area_m2 * height_m)})});
    model_.root("IFCRELDEFINESBYPROPERTIES", thing, "", {kNone, list({space}), quantities});
  }

  void add_walls() {
    for (const WallSegment& segment : segments_) {
      const auto& axis = segment.axis;
      const Point2 along = axis ? Point2(axis->b - axis->a) : Point2(1.0, 0.0);
      const Pose2 pose =
          axis ? Pose2{axis->a.x(), axis->a.y(), std::atan2(along.y(), along.x())} : Pose2{};
      const IfcFrame frame = model_.frame(&storey_, pose, 0.0);
      const Segment2 line{{0.0, 0.0}, {along.norm(), 0.0}};
      const double half_m = segment.thickness_m / 2.0;
      const Value solid =
          segment.is_rectangle
              ? model_.box({{0.0, -half_m}, {along.norm(), half_m}}, 0.0, options_.storey_height_m)
              : model_.extrusion(frame, segment.outline, options_.storey_height_m);
      const std::string thing = axis ? millimetres(axis->a) + "/" + millimetres(axis->b)
                                     : millimetres(segment.outline.outer.front()) + "/rest";
      walls_.push_back(
          model_.root("IFCWALL", thing, "Wall " + std::to_string(walls_.size() + 1),
                      {kNone, kNone, frame.placement, model_.shape({solid}, axis ? &line : nullptr),
                       kNone, word(axis ? "SOLIDWALL" : "NOTDEFINED")}));
      frames_.push_back(frame);
      if (axis) of_thickness_[std::llround(1000.0 * segment.thickness_m)].push_back(walls_.back());
    }
    elements_ = walls_;
    for (const auto& [thickness_mm, walls] : of_thickness_) add_material(thickness_mm, walls);
  }

  /// What a wall is made of is not known; how thick it is, is.
  void add_material(long long thickness_mm, const std::vector<Value>& walls) {
    const std::string name = "Wall " + std::to_string(thickness_mm) + " mm";
    const double thickness_m = 0.001 * static_cast<double>(thickness_mm);
    io::step::File& file = model_.file();
    const Value material = file.shared("IFCMATERIAL", {text("Unknown"), kNone, kNone});
    const Value layer = file.add("IFCMATERIALLAYER",
                                 {material, real(thickness_m), kNone, kNone, kNone, kNone, kNone});
    const Value set = file.add("IFCMATERIALLAYERSET", {list({layer}), text(name), kNone});
    const Value usage = file.add("IFCMATERIALLAYERSETUSAGE", {set, word("AXIS2"), word("POSITIVE"),
                                                              real(-thickness_m / 2.0), kNone});
    model_.root("IFCRELASSOCIATESMATERIAL", name, "", {kNone, list(walls), usage});
  }

  void add_doors() {
    const std::vector<std::string> keys = door_keys(plan_);
    for (std::size_t i = 0; i < keys.size(); ++i) add_door(plan_.doors[i], keys[i]);
  }

  /// Holes in all walls that stand in it, and what fills the one in the wall that has most of it.
  void add_door(const PlanDoor& door, const std::string& key) {
    if ((door.jambs.b - door.jambs.a).norm() < 1e-3) return;
    const Hole hole = hole_of(door, options_.storey_height_m);
    std::vector<std::pair<double, std::size_t>> hosts;
    for (std::size_t k = 0; k < segments_.size() && door.opening.size() > 2; ++k) {
      const double m2 = shared_area(door.opening, segments_[k].outline);
      if (m2 > kLeastVoid_m2) hosts.emplace_back(-m2, k);
    }
    std::sort(hosts.begin(), hosts.end());
    const IfcFrame* host = &storey_;
    IfcFrame frame;
    Value opening;
    for (std::size_t n = 0; n < hosts.size(); ++n) {
      const std::size_t wall = hosts[n].second;
      const std::string thing = key + (n == 0 ? "" : "/" + std::to_string(n + 1));
      const IfcFrame at = model_.frame(&frames_[wall], hole.building_from_hole, hole.from_m);
      const Value made = add_opening(thing, at, hole);
      model_.root("IFCRELVOIDSELEMENT", thing, "", {kNone, walls_[wall], made});
      if (n > 0) continue;
      frame = at;
      host = &frame;
      opening = made;
    }
    if (door.kind == DoorKind::passage) return;
    const Value filling = add_filling(door, key, *host, hole);
    elements_.push_back(filling);
    if (!opening.empty()) model_.root("IFCRELFILLSELEMENT", key, "", {kNone, opening, filling});
  }

  static double shared_area(const Ring& ring, const Polygon& wall) {
    const Box2 a = bounds(ring);
    const Box2 b = bounds(wall.outer);
    const bool is_apart =
        (a.min.array() >= b.max.array()).any() || (b.min.array() >= a.max.array()).any();
    return is_apart ? 0.0 : overlap_area({{ring, {}}}, {wall});
  }

  Value add_opening(const std::string& thing, const IfcFrame& frame, const Hole& hole) {
    Box2 box = hole.box;
    box.min.y() -= kBeyondWall_m;
    box.max.y() += kBeyondWall_m;
    return model_.root(
        "IFCOPENINGELEMENT", thing, "Opening " + thing,
        {kNone, kNone, frame.placement, model_.shape({model_.box(box, 0.0, hole.height_m)}), kNone,
         word("OPENING")});
  }

  Value add_filling(const PlanDoor& door, const std::string& key, const IfcFrame& parent,
                    const Hole& hole) {
    const IfcFrame frame = model_.frame(&parent, hole.building_from_hole, hole.from_m);
    const double width_m = hole.box.size().x();
    const Value shape = model_.shape(
        {model_.box({{0.0, -kPanel_m / 2.0}, {width_m, kPanel_m / 2.0}}, 0.0, hole.height_m)});
    const bool is_window = door.kind == DoorKind::window;
    return model_.root(
        is_window ? "IFCWINDOW" : "IFCDOOR", key, (is_window ? "Window " : "Door ") + key,
        {kNone, kNone, frame.placement, shape, text(std::to_string(door.id)), real(hole.height_m),
         real(width_m), word(is_window ? "WINDOW" : "DOOR"), word(hole.operation), kNone});
  }

  void add_furniture() {
    for (std::size_t i = 0; i < plan_.furniture.size(); ++i) {
      const PlanFurniture& piece = plan_.furniture[i];
      if (area(piece.outline) < kLeastVoid_m2) continue;
      const std::string thing = std::to_string(i + 1);
      const IfcFrame frame = model_.frame(&storey_, {}, 0.0);
      elements_.push_back(
          model_.root("IFCFURNITURE", thing, "Furniture " + thing,
                      {kNone, text(to_string(piece.kind)), frame.placement,
                       model_.shape({model_.extrusion(frame, piece.outline, kFurniture_m)}), kNone,
                       word("NOTDEFINED")}));
    }
  }

  void relate() {
    aggregate("storey", storey_entity_, spaces_);
    if (elements_.empty()) return;
    model_.root("IFCRELCONTAINEDINSPATIALSTRUCTURE", "storey", "",
                {kNone, list(elements_), storey_entity_});
  }

  const FloorPlan& plan_;
  const IfcOptions& options_;
  std::vector<WallSegment> segments_;
  IfcModel model_;
  IfcFrame storey_;
  Value storey_entity_;
  std::vector<Value> spaces_, walls_, elements_;
  std::vector<IfcFrame> frames_;  ///< of the walls
  std::map<long long, std::vector<Value>> of_thickness_;
};

}  // namespace

std::string ifc_step(const FloorPlan& plan, const IfcOptions& options) {
  return Building(plan, options).step();
}

}  // namespace roomatlas
