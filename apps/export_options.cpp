// SPDX-License-Identifier: GPL-3.0-or-later
#include "export_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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

PostalAddress ExportOptions::postal_address() const {
  std::vector<std::string> fields;
  std::istringstream stream(address);
  for (std::string field; std::getline(stream, field, ';');) fields.push_back(field);
  fields.resize(std::max<std::size_t>(fields.size(), 4));
  const std::string& country = fields[2];
  const bool is_code =
      country.size() == 2 &&
      std::all_of(country.begin(), country.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (!address.empty() && (fields.size() > 4 || !is_code)) {
    throw UsageError(fmt::format(
        "--address: \"{}\" is no address: expected STREET;CITY;COUNTRY or "
        "STREET;CITY;COUNTRY;POSTCODE with a country of two capital letters (ISO 3166), such as "
        "\"Am Ring 5;Freiburg;DE;79110\"",
        address));
  }
  return {fields[0], fields[1], country, fields[3]};
}

std::optional<double> ExportOptions::north_deg() const {
  if (north) return north;
  if (const auto on_earth = reference()) return -on_earth->heading_deg;
  return std::nullopt;
}

}  // namespace roomatlas::apps
