// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/nav2_export.hpp"

#include "files/output_file.hpp"
#include "plan_raster.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/plans/room_tables.hpp"
#include "text/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

using io::PlanRaster;

using io::RasterFrame;

std::string pgm_head(const RasterFrame& frame) {
  return "P5\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n255\n";
}

/// The rows from the highest, as a picture has them.
std::string bytes_of(const io::CellGrid<std::uint8_t>& cells) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height()));
  for (int y = cells.height() - 1; y >= 0; --y) {
    for (int x = 0; x < cells.width(); ++x) bytes += static_cast<char>(cells(x, y));
  }
  return bytes;
}

/// What nav2's map server reads. Thresholds are such that 205 is unknown.
std::string yaml_of(const RasterFrame& frame, const char* picture) {
  const auto number = [](double value) {
    std::string text;
    io::append_number(text, std::round(value * 1e6) / 1e6 + 0.0);
    return text;
  };
  return std::string("image: ") + picture + "\nmode: trinary\nresolution: " + number(frame.cell_m) +
         "\norigin: [" + number(frame.origin_m.x()) + ", " + number(frame.origin_m.y()) +
         ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

/// Everything that is not known to be free is kept out of.
void keep_out(std::string& cells) {
  constexpr char kFree = static_cast<char>(PlanRaster::kFree);
  constexpr char kOccupied = static_cast<char>(PlanRaster::kOccupied);
  std::replace_if(
      cells.begin(), cells.end(), [](char cell) { return cell != kFree; }, kOccupied);
}

/// Both pictures, some rows at a time.
void write_pictures(const std::filesystem::path& folder, const FloorPlan& plan,
                    const RasterFrame& frame, int rows_at_once) {
  io::OutputFile map(folder / "map.pgm");
  io::OutputFile mask(folder / "keepout_mask.pgm");
  for (io::OutputFile* file : {&map, &mask}) file->write(pgm_head(frame));
  for (int end = frame.height; end > 0; end -= rows_at_once) {
    const int first = std::max(0, end - rows_at_once);
    std::string cells = bytes_of(io::rows_of(plan, frame, first, end - first).cells);
    map.write(cells);
    keep_out(cells);
    mask.write(cells);
  }
  map.commit();
  mask.commit();
}

}  // namespace

std::vector<std::string> write_nav2_map(const std::filesystem::path& folder, const FloorPlan& plan,
                                        const Nav2Options& options) {
  const RasterFrame frame = io::frame_of(plan, options.cell_m, options.margin_m);
  write_pictures(folder, plan, frame, std::max(1, options.cells_at_once / frame.width));
  write_file(folder / "map.yaml", yaml_of(frame, "map.pgm"));
  write_file(folder / "keepout_mask.yaml", yaml_of(frame, "keepout_mask.pgm"));
  write_file(folder / "rooms.yaml", rooms_yaml(plan));
  return {"map.pgm", "map.yaml", "keepout_mask.pgm", "keepout_mask.yaml", "rooms.yaml"};
}

bool fits_nav2_map(const FloorPlan& plan, const Nav2Options& options) {
  return !io::is_too_large(plan, options.cell_m, options.margin_m);
}

}  // namespace roomatlas
