// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_formats.hpp"

#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "roomatlas/io/maps/nav2_export.hpp"
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::apps {
namespace {

using Names = std::vector<std::string>;

/// Formats that a package of their own writes.
struct Extra {
  Names formats;
  std::string package;
  bool (*is_there)();
};

const std::vector<Extra>& extras() {
  static const std::vector<Extra> all = {{{"pdf", "png"}, "roomatlas-pictures", has_pictures},
                                         {{"dxf"}, "roomatlas-gdal", has_ogr}};
  return all;
}

Names with_packages(const Names& formats) {
  Names possible = formats;
  for (const Extra& extra : extras()) {
    Names asked;
    for (const std::string& format : formats) {
      if (std::find(extra.formats.begin(), extra.formats.end(), format) != extra.formats.end()) {
        asked.push_back(format);
      }
    }
    if (asked.empty() || extra.is_there()) continue;
    spdlog::warn("no {}: `apt-get install {}` brings that", fmt::join(asked, ", "), extra.package);
    std::erase_if(possible, [&](const std::string& format) {
      return std::find(asked.begin(), asked.end(), format) != asked.end();
    });
  }
  return possible;
}

}  // namespace

Names possible_formats(const Names& formats, const Path& store_file) {
  Names possible = with_packages(formats);
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  if (std::count(possible.begin(), possible.end(), "nav2") == 0 || !store.has_assembly()) {
    return possible;
  }
  if (!fits_nav2_map(store.plan())) {
    spdlog::warn("no nav2: the plan is too large for a map of cells");
    std::erase(possible, "nav2");
  }
  return possible;
}

void write_picture(const Path& png, const std::string& svg, double dots_per_inch) {
  if (!with_packages({"png"}).empty()) write_png(png, svg, dots_per_inch);
}

}  // namespace roomatlas::apps
