// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/io/plans/georeference.hpp"

namespace roomatlas {

/// A postal address as IMDF has it. What is empty is written as unknown.
struct PostalAddress {
  std::string street;       ///< and number
  std::string locality;     ///< city
  std::string country;      ///< ISO 3166-1, two letters
  std::string postal_code;  ///< may stay empty
};

struct ImdfOptions {
  std::string building;   ///< what the identifiers hang on, see `FeatureIds`
  GeoReference on_earth;  ///< where the plan lies
  PostalAddress address;
  std::string date;  ///< YYYY-MM-DD, of the manifest; 1970-01-01 where empty
};

/// The plan as an archive of the Indoor Mapping Data Format (OGC 20-094, version 1.0.0): a ZIP
/// file with manifest.json and a GeoJSON file for each type of feature that there is: address,
/// venue, building, footprint, level, unit, opening, fixture and relationship. docs/formats.md says
/// what becomes what. Two rooms that a door joins touch along its door line, so that each opening
/// lies on the boundary of its units. Throws InputError where a coordinate is not finite.
[[nodiscard]] std::string imdf_archive(const FloorPlan& plan, const ImdfOptions& options);

/// The unit category of a room: by a word of its name where somebody named it so ("Kitchen 2",
/// "Meeting room"), else by its kind.
[[nodiscard]] std::string imdf_category(const PlanRoom& room);

}  // namespace roomatlas
