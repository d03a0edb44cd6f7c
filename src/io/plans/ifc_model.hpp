// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "roomatlas/core/geometry.hpp"
#include "roomatlas/io/plans/feature_ids.hpp"
#include "step_file.hpp"

/// What the things of an IFC4 model are made of. Private.
namespace roomatlas::io {

/// A frame of the model, and where it is in the building.
struct IfcFrame {
  step::Value placement;  ///< IfcLocalPlacement
  Pose2 building_from_frame;
  double elevation_m = 0.0;
};

class IfcModel {
 public:
  /// Writes units and contexts. @param north in the plan, unit length
  IfcModel(std::string building, const Point2& north);

  /// An IfcRoot: GlobalId (by the thing), OwnerHistory (none), Name, and the rest as given.
  step::Value root(const std::string& type, const std::string& thing, const std::string& name,
                   std::initializer_list<step::Value> rest);

  /// @param pose in the building
  IfcFrame frame(const IfcFrame* parent, const Pose2& building_from_frame, double elevation_m);

  /// A polygon of the building, raised from the frame's height.
  step::Value extrusion(const IfcFrame& frame, const Polygon& polygon, double height_m);
  /// The same of a rectangle of the frame, between two corners. @param from_m above the frame
  step::Value box(const Box2& in_frame, double from_m, double height_m);

  /// IfcProductDefinitionShape with a body of swept solids, and an axis (two points of the frame)
  /// where one is given.
  step::Value shape(const std::vector<step::Value>& solids,
                    const Segment2* axis_in_frame = nullptr);

  [[nodiscard]] const step::Value& context() const { return context_; }
  [[nodiscard]] const step::Value& units() const { return units_; }
  step::File& file() { return file_; }

 private:
  step::Value point(const Point2& at);
  step::Value point(const Point2& at, double z_m);
  step::Value direction(std::initializer_list<double> components);
  step::Value polyline(const Ring& ring);
  step::Value raised(const step::Value& profile, double from_m, double height_m);

  FeatureIds ids_;
  step::File file_;
  step::Value units_;
  step::Value context_;
  step::Value body_;
  step::Value axis_;
};

}  // namespace roomatlas::io
