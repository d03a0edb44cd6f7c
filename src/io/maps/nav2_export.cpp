// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/nav2_export.hpp"

#include "plan_raster.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/plans/room_tables.hpp"
#include "text/numbers.hpp"

#include <cmath>
#include <utility>

namespace roomatlas {
namespace {

using io::PlanRaster;

std::string pgm_of(const io::CellGrid<std::uint8_t>& cells) {
  std::string pgm =
      "P5\n" + std::to_string(cells.width()) + " " + std::to_string(cells.height()) + "\n255\n";
  pgm.reserve(pgm.size() +
              static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height()));
  for (int y = cells.height() - 1; y >= 0; --y) {
    for (int x = 0; x < cells.width(); ++x) pgm += static_cast<char>(cells(x, y));
  }
  return pgm;
}

/// What nav2's map server reads. Thresholds are such that 205 is unknown.
std::string yaml_of(const PlanRaster& raster, const char* picture) {
  const auto number = [](double value) {
    std::string text;
    io::append_number(text, std::round(value * 1e6) / 1e6 + 0.0);
    return text;
  };
  return std::string("image: ") + picture +
         "\nmode: trinary\nresolution: " + number(raster.cell_m) + "\norigin: [" +
         number(raster.origin_m.x()) + ", " + number(raster.origin_m.y()) +
         ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

/// Everything that is not known to be free is kept out of.
PlanRaster keepout_of(PlanRaster mask) {
  for (int y = 0; y < mask.cells.height(); ++y) {
    for (int x = 0; x < mask.cells.width(); ++x) {
      if (mask.cells(x, y) != PlanRaster::kFree) mask.cells(x, y) = PlanRaster::kOccupied;
    }
  }
  return mask;
}

}  // namespace

std::vector<std::string> write_nav2_map(const std::filesystem::path& folder, const FloorPlan& plan,
                                        const Nav2Options& options) {
  PlanRaster map = io::raster_of(plan, options.cell_m, options.margin_m);
  write_file(folder / "map.pgm", pgm_of(map.cells));
  write_file(folder / "map.yaml", yaml_of(map, "map.pgm"));
  write_file(folder / "keepout_mask.yaml", yaml_of(map, "keepout_mask.pgm"));
  write_file(folder / "keepout_mask.pgm", pgm_of(keepout_of(std::move(map)).cells));
  write_file(folder / "rooms.yaml", rooms_yaml(plan));
  return {"map.pgm", "map.yaml", "keepout_mask.pgm", "keepout_mask.yaml", "rooms.yaml"};
}

bool fits_nav2_map(const FloorPlan& plan, const Nav2Options& options) {
  return !io::is_too_large(plan, options.cell_m, options.margin_m);
}

}  // namespace roomatlas
