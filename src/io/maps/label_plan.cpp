// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/maps/label_plan.hpp"

#include <algorithm>

#include "label_rooms.hpp"
#include "pictures/picture.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {

FloorPlan read_label_plan(const std::filesystem::path& file, double pixel_m) {
  if (!(pixel_m > 0.0)) throw UsageError("the size of a pixel must be more than 0 metres");
  const io::Picture picture = io::parse_picture(io::read_unpacked(file), file.string());
  io::CellGrid<int> labels = picture.values;
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) labels(x, y) = std::max(0, labels(x, y));
  }
  FloorPlan plan;
  plan.rooms =
      io::rooms_of_labels(labels, [&](const Point2& corner) { return Point2(pixel_m * corner); });
  if (plan.rooms.empty()) {
    throw InputError(file.string() + ": holds no room: every pixel is 0; expected room numbers");
  }
  return plan;
}

}  // namespace roomatlas
