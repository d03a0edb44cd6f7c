// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_imdf.hpp"

#include "console.hpp"
#include "roomatlas/io/files/files.hpp"

namespace roomatlas::apps {

void write_imdf(const std::filesystem::path& file, const FloorPlan& plan,
                const std::optional<GeoReference>& on_earth, ImdfOptions options) {
  if (!on_earth) {
    show({{Severity::warning, file.string(), 0, "",
           "where the building is was not said: it lies at latitude 0, longitude 0 with its y axis "
           "to the north; give --georef LAT,LON,HEADING"}});
  }
  if (options.address.country.empty()) {
    show({{Severity::warning, file.string(), 0, "",
           "the venue's address was not said: it is \"unknown\" in the country ZZ; give --address "
           "\"STREET;CITY;COUNTRY\""}});
  }
  options.on_earth = on_earth.value_or(GeoReference{});
  write_file(file, imdf_archive(plan, options));
}

}  // namespace roomatlas::apps
