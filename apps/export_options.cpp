// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>

#include "limits.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {

namespace {

/// @throws UsageError naming the value and the limits that it is out of
void require_within(const char* name, double value_deg, double limit_deg) {
  if (std::abs(value_deg) <= limit_deg) return;
  throw UsageError(fmt::format(
      "--georef: the {0} {1} is not in -{2} to {2} degrees: expected LAT,LON,HEADING, such as "
      "48.0130,7.8335,12.5",
      name, value_deg, limit_deg));
}

}  // namespace

std::optional<GeoReference> ExportOptions::reference() const {
  if (georef.empty()) return std::nullopt;
  const GeoReference reference{georef.at(0), georef.at(1), georef.at(2)};
  require_within("latitude", reference.latitude_deg, 85.0);
  require_within("longitude", reference.longitude_deg, 180.0);
  require_within("heading", reference.heading_deg, 360.0);
  return reference;
}

std::optional<double> ExportOptions::north_deg() const {
  if (north) return north;
  if (const auto on_earth = reference()) return -on_earth->heading_deg;
  return std::nullopt;
}

void add_export_options(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--georef", options.georef,
                   "LAT,LON,HEADING: where the plan's origin is, and the compass direction of its "
                   "y axis, in deg; plan.geojson is then on the earth")
      ->delimiter(',')
      ->expected(3)
      ->configurable(false);
  command
      ->add_option("--north", options.north,
                   "deg, clockwise from up the plan: where north is; as --georef says without it")
      ->check(within(-360.0, 360.0))
      ->configurable(false);
}

void add_measured_walls(CLI::App* command, ExportOptions& options) {
  command
      ->add_flag("--measured-walls", options.measured_walls,
                 "the walls as measured, where `assemble` made them regular")
      ->configurable(false);
}

void add_ogr_option(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--ogr", options.ogr_driver,
                   "vector format of GDAL for -f ogr, such as GML or \"ESRI Shapefile\"")
      ->configurable(false);
}

}  // namespace roomatlas::apps
