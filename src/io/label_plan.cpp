// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/label_plan.hpp"

#include <algorithm>
#include <map>

#include "pgm.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/polyline/region.hpp"

namespace roomatlas {
namespace {

/// The pixels of one label, in a box with a free rim.
CellMask mask_of(const io::GreyPicture& picture, std::uint16_t label, const CellBox& box) {
  CellMask mask({{box.min.x - 1, box.min.y - 1}, {box.max.x + 1, box.max.y + 1}});
  for_each_cell(box, [&](const Cell& cell) {
    if (picture.at(cell.x, picture.height - 1 - cell.y) == label) mask.set(cell, true);
  });
  return mask;
}

/// The corners of a boundary that is given by the middles of its pixel edges.
Ring corners_of(const CellBoundary& boundary, const CellFrame& frame) {
  Ring corners;
  Point2 former_along = Point2::Zero();
  const auto along_of = [&](std::size_t i) {
    const Point2 out = frame.center_of(boundary.outside_cells[i]) - boundary.edge_midpoints[i];
    return Point2(-out.y(), out.x());  // the region is on the left; as long as half an edge
  };
  const std::size_t count = boundary.edge_midpoints.size();
  former_along = along_of(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 along = along_of(i);
    if ((along - former_along).norm() > 0.1 * frame.cell_m) {
      corners.push_back(boundary.edge_midpoints[i] - along);
    }
    former_along = along;
  }
  return corners;
}

std::vector<Polygon> polygons_of(const CellMask& mask, const CellFrame& frame) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (const CellBoundary& boundary : trace_boundaries(mask, frame)) {
    Ring ring = corners_of(boundary, frame);
    if (signed_area(ring) > 0.0) {
      polygons.push_back({std::move(ring), {}});
    } else {
      holes.push_back(std::move(ring));
    }
  }
  std::stable_sort(polygons.begin(), polygons.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  for (Ring& hole : holes) {
    const Point2 inside = hole[0] + 0.25 * ((hole[1] - hole[0]).normalized() * frame.cell_m) +
                          0.25 * ((hole.back() - hole[0]).normalized() * frame.cell_m);
    const auto around = std::find_if(polygons.begin(), polygons.end(), [&](const Polygon& polygon) {
      return contains(polygon.outer, inside) && area(polygon) > -signed_area(hole);
    });
    if (around != polygons.end()) around->holes.push_back(std::move(hole));
  }
  std::reverse(polygons.begin(), polygons.end());
  return polygons;
}

std::map<std::uint16_t, CellBox> boxes_of(const io::GreyPicture& picture) {
  std::map<std::uint16_t, CellBox> boxes;
  for_each_cell({{0, 0}, {picture.width, picture.height}}, [&](const Cell& cell) {
    const std::uint16_t label = picture.at(cell.x, picture.height - 1 - cell.y);
    if (label == 0) return;
    CellBox& box = boxes.try_emplace(label, CellBox{cell, cell}).first->second;
    box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
    box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
  });
  return boxes;
}

}  // namespace

FloorPlan read_label_plan(const std::filesystem::path& file, double pixel_m) {
  if (!(pixel_m > 0.0)) throw UsageError("the size of a pixel must be more than 0 metres");
  const io::GreyPicture picture = io::read_pgm(file);
  const CellFrame frame{pixel_m};
  FloorPlan plan;
  for (const auto& [label, box] : boxes_of(picture)) {
    PlanRoom& room = plan.rooms.emplace_back();
    room.id = label;
    room.name = std::to_string(label);
    room.parts = polygons_of(mask_of(picture, label, box), frame);
    for (const Polygon& part : room.parts) room.area_m2 += area(part);
    room.label_point = interior_point(room.parts.front());
  }
  if (plan.rooms.empty()) {
    throw InputError(file.string() + ": holds no room: every pixel is 0; expected room numbers");
  }
  return plan;
}

}  // namespace roomatlas
