// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomatlas/io/plans/georeference.hpp"
#include "roomatlas/io/plans/imdf.hpp"

namespace roomatlas::apps {

/// What `export` and `build` are told besides the parameters.
struct ExportOptions {
  std::vector<double> georef;    ///< latitude, longitude, heading of the y axis in deg; or empty
  std::optional<double> north;   ///< where north is on the plan, clockwise from up in deg
  std::string ogr_driver;        ///< of the format `ogr`
  std::string address;           ///< STREET;CITY;COUNTRY;POSTCODE, of the format `imdf`; or empty
  double storey_height_m = 2.5;  ///< of the format `ifc`; no robot measures it
  bool measured_walls = false;   ///< walls as measured instead of regular ones

  /// Throws UsageError when it is not on the earth.
  [[nodiscard]] std::optional<GeoReference> reference() const;
  /// What is not given is empty. Throws UsageError when it is no address.
  [[nodiscard]] PostalAddress postal_address() const;
  /// As given, else as the place on earth has it, in deg clockwise from up the plan.
  [[nodiscard]] std::optional<double> north_deg() const;
};

}  // namespace roomatlas::apps
