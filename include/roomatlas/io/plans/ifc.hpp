// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "roomatlas/io/plans/georeference.hpp"

namespace roomatlas {

struct IfcOptions {
  std::string building;                  ///< what GlobalIds hang on, see `FeatureIds`
  std::optional<GeoReference> on_earth;  ///< of the site, where it is known
  std::string date;                      ///< YYYY-MM-DD, of the file; 1970-01-01 where empty
  double storey_height_m = 2.5;          ///< [2, 20]; of rooms and walls, which no robot measures
};

/// The plan as a building model: IFC4 (ISO 16739) in a STEP file, in metres. One storey with its
/// spaces; straight walls as rectangles with their thickness, openings that void them, doors and
/// windows that fill the openings; furniture. docs/formats.md says what becomes what, and which
/// heights are assumed. Throws InputError where a coordinate is not finite.
[[nodiscard]] std::string ifc_step(const FloorPlan& plan, const IfcOptions& options);

}  // namespace roomatlas
