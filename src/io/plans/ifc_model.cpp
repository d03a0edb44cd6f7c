// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc_model.hpp"

#include <cmath>

namespace roomatlas::io {
namespace {

using namespace step;

/// Without repeated points; what GlobalIds and shapes are asked for is in millimetres.
Ring without_repeats(const Ring& ring) {
  constexpr double kApart_m = 1e-4;
  Ring kept;
  for (const Point2& point : ring) {
    if (kept.empty() || (point - kept.back()).norm() > kApart_m) kept.push_back(point);
  }
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= kApart_m) kept.pop_back();
  return kept;
}

Ring in_frame(const IfcFrame& frame, const Ring& ring) {
  const Pose2 frame_from_building = inverse(frame.building_from_frame);
  Ring moved;
  for (const Point2& point : ring) moved.push_back(frame_from_building * point);
  return without_repeats(moved);
}

}  // namespace

IfcModel::IfcModel(std::string building, const Point2& north) : ids_(std::move(building)) {
  const auto unit = [&](const char* kind, const char* name) {
    return file_.add("IFCSIUNIT", {kDerived, word(kind), kNone, word(name)});
  };
  units_ = file_.add("IFCUNITASSIGNMENT",
                     {list({unit("LENGTHUNIT", "METRE"), unit("AREAUNIT", "SQUARE_METRE"),
                            unit("VOLUMEUNIT", "CUBIC_METRE"), unit("PLANEANGLEUNIT", "RADIAN")})});
  const Value world = file_.shared("IFCAXIS2PLACEMENT3D", {point({0.0, 0.0}, 0.0), kNone, kNone});
  context_ =
      file_.add("IFCGEOMETRICREPRESENTATIONCONTEXT",
                {kNone, text("Model"), "3", "1.E-5", world, direction({north.x(), north.y()})});
  const auto part = [&](const char* name, const char* view) {
    return file_.add("IFCGEOMETRICREPRESENTATIONSUBCONTEXT",
                     {text(name), text("Model"), kDerived, kDerived, kDerived, kDerived, context_,
                      kNone, word(view), kNone});
  };
  body_ = part("Body", "MODEL_VIEW");
  axis_ = part("Axis", "GRAPH_VIEW");
}

Value IfcModel::root(const std::string& type, const std::string& thing, const std::string& name,
                     std::initializer_list<Value> rest) {
  std::vector<Value> arguments = {"'" + ids_.of(type + "/" + thing).ifc() + "'", kNone,
                                  name.empty() ? Value(kNone) : text(name)};
  arguments.insert(arguments.end(), rest.begin(), rest.end());
  return file_.add(type, arguments);
}

Value IfcModel::point(const Point2& at) {
  return file_.shared("IFCCARTESIANPOINT", {list({real(at.x()), real(at.y())})});
}

Value IfcModel::point(const Point2& at, double z_m) {
  return file_.shared("IFCCARTESIANPOINT", {list({real(at.x()), real(at.y()), real(z_m)})});
}

Value IfcModel::direction(std::initializer_list<double> components) {
  std::vector<Value> values;
  for (const double component : components) values.push_back(real(component));
  return file_.shared("IFCDIRECTION", {list(values)});
}

IfcFrame IfcModel::frame(const IfcFrame* parent, const Pose2& building_from_frame,
                         double elevation_m) {
  const Pose2 base = parent == nullptr ? Pose2{} : parent->building_from_frame;
  const Pose2 pose = inverse(base) * building_from_frame;
  const double z_m = elevation_m - (parent == nullptr ? 0.0 : parent->elevation_m);
  const bool is_turned = std::abs(pose.theta_rad) > 1e-12;
  const Value up = is_turned ? direction({0.0, 0.0, 1.0}) : Value(kNone);
  const Value along = is_turned
                          ? direction({std::cos(pose.theta_rad), std::sin(pose.theta_rad), 0.0})
                          : Value(kNone);
  const Value axes = file_.shared("IFCAXIS2PLACEMENT3D", {point(pose.position(), z_m), up, along});
  const Value on = parent == nullptr ? Value(kNone) : parent->placement;
  return {file_.add("IFCLOCALPLACEMENT", {on, axes}), building_from_frame, elevation_m};
}

Value IfcModel::polyline(const Ring& ring) {
  std::vector<Value> points;
  for (const Point2& at : ring) points.push_back(point(at));
  points.push_back(points.front());
  return file_.add("IFCPOLYLINE", {list(points)});
}

Value IfcModel::raised(const Value& profile, double from_m, double height_m) {
  const Value base = file_.shared("IFCAXIS2PLACEMENT3D", {point({0.0, 0.0}, from_m), kNone, kNone});
  return file_.add("IFCEXTRUDEDAREASOLID",
                   {profile, base, direction({0.0, 0.0, 1.0}), real(height_m)});
}

Value IfcModel::extrusion(const IfcFrame& frame, const Polygon& polygon, double height_m) {
  const Value outer = polyline(in_frame(frame, polygon.outer));
  std::vector<Value> holes;
  for (const Ring& hole : polygon.holes) {
    const Ring ring = in_frame(frame, hole);
    if (ring.size() > 2) holes.push_back(polyline(ring));
  }
  const Value profile =
      holes.empty()
          ? file_.add("IFCARBITRARYCLOSEDPROFILEDEF", {word("AREA"), kNone, outer})
          : file_.add("IFCARBITRARYPROFILEDEFWITHVOIDS", {word("AREA"), kNone, outer, list(holes)});
  return raised(profile, 0.0, height_m);
}

Value IfcModel::box(const Box2& in_frame, double from_m, double height_m) {
  const Point2 middle = (in_frame.min + in_frame.max) / 2.0;
  const Value place = file_.shared("IFCAXIS2PLACEMENT2D", {point(middle), kNone});
  const Value profile =
      file_.add("IFCRECTANGLEPROFILEDEF",
                {word("AREA"), kNone, place, real(in_frame.size().x()), real(in_frame.size().y())});
  return raised(profile, from_m, height_m);
}

Value IfcModel::shape(const std::vector<Value>& solids, const Segment2* axis_in_frame) {
  std::vector<Value> parts;
  if (axis_in_frame != nullptr) {
    const Value line =
        file_.add("IFCPOLYLINE", {list({point(axis_in_frame->a), point(axis_in_frame->b)})});
    parts.push_back(
        file_.add("IFCSHAPEREPRESENTATION", {axis_, text("Axis"), text("Curve2D"), list({line})}));
  }
  parts.push_back(
      file_.add("IFCSHAPEREPRESENTATION", {body_, text("Body"), text("SweptSolid"), list(solids)}));
  return file_.add("IFCPRODUCTDEFINITIONSHAPE", {kNone, kNone, list(parts)});
}

}  // namespace roomatlas::io
