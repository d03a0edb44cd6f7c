// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelled_map.hpp"

#include <algorithm>
#include <cmath>

#include "pictures/picture.hpp"

namespace roomatlas::bench {
namespace {

constexpr double kPixelM = 0.05;
constexpr int kFreeGrey = 250;
constexpr int kObstacleGrey = 100;  // darker; what is between was not seen

LabelledMap empty_like(const LabelledMap& map, double cell_m, const CellBox& box) {
  LabelledMap result;
  result.name = map.name;
  result.furnished = map.furnished;
  result.evidence.frame.cell_m = cell_m;
  result.evidence.free = CellMask(box);
  result.evidence.obstacle = CellMask(box);
  result.true_room = Raster<std::int32_t>(box, 0);
  return result;
}

io::Picture picture(const std::filesystem::path& file) {
  return io::parse_picture(io::read_unpacked(file), file.string());
}

}  // namespace

std::vector<std::string> labelled_map_names(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

LabelledMap read_labelled_map(const std::filesystem::path& folder, const std::string& name,
                              bool furnished) {
  const std::filesystem::path stem = folder / name / name;
  const io::Picture grey = picture(stem.string() + (furnished ? "_furnitures.png" : ".png"));
  const io::Picture labels = picture(stem.string() + "_gt_labels.pgm.gz");
  LabelledMap blank;
  blank.name = name;
  blank.furnished = furnished;
  LabelledMap map =
      empty_like(blank, kPixelM, {{0, 0}, {grey.values.width(), grey.values.height()}});
  for_each_cell(map.true_room.domain, [&](const Cell& cell) {
    const int value = grey.values(cell.x, cell.y);
    map.evidence.free.set(cell, value >= kFreeGrey);
    map.evidence.obstacle.set(cell, value >= 0 && value < kObstacleGrey);
    map.true_room[cell] = labels.values.get(cell.x, cell.y, 0);
  });
  return map;
}

LabelledMap turned(const LabelledMap& map, double angle_rad) {
  const double cell_m = map.evidence.frame.cell_m;
  const CellBox& from = map.true_room.domain.bounds();
  const Pose2 old_from_new{0.0, 0.0, -angle_rad};
  Box2 reach;
  for (const double x : {from.min.x * cell_m, from.max.x * cell_m}) {
    for (const double y : {from.min.y * cell_m, from.max.y * cell_m}) {
      reach.extend(inverse(old_from_new) * Point2(x, y));
    }
  }
  LabelledMap result = empty_like(
      map, cell_m, {map.evidence.frame.cell_of(reach.min), map.evidence.frame.cell_of(reach.max)});
  for_each_cell(result.true_room.domain, [&](const Cell& cell) {
    const Cell old = map.evidence.frame.cell_of(old_from_new * map.evidence.frame.center_of(cell));
    result.evidence.free.set(cell, map.evidence.free.at(old));
    result.evidence.obstacle.set(cell, map.evidence.obstacle.at(old));
    result.true_room[cell] = map.true_room.get(old);
  });
  return result;
}

LabelledMap halved(const LabelledMap& map) {
  const CellBox& from = map.true_room.domain.bounds();
  const auto half = [](int value) { return static_cast<int>(std::floor(value / 2.0)); };
  LabelledMap result = empty_like(
      map, 2.0 * map.evidence.frame.cell_m,
      {{half(from.min.x), half(from.min.y)}, {half(from.max.x + 1), half(from.max.y + 1)}});
  for_each_cell(result.true_room.domain, [&](const Cell& cell) {
    int free = 0;
    int obstacles = 0;
    std::int32_t room = 0;
    for (int k = 0; k < 4; ++k) {
      const Cell old{2 * cell.x + k % 2, 2 * cell.y + k / 2};
      if (map.evidence.free.at(old)) ++free;
      if (map.evidence.obstacle.at(old)) ++obstacles;
      room = std::max(room, map.true_room.get(old));
    }
    result.evidence.free.set(cell, obstacles == 0 && free >= 2);
    result.evidence.obstacle.set(cell, obstacles > 0);
    result.true_room[cell] = room;
  });
  return result;
}

}  // namespace roomatlas::bench
