// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_grid.hpp"

namespace roomatlas {

void LiveGrid::clear() {
  grid_ = HimmGrid(options_.cell_m);
  begun_ = {};
  undrawn_.clear();
  last_added_.reset();
}

void LiveGrid::add(const RangeReading& reading, const Pose2& asr_from_robot) {
  if (last_added_ && !moved_enough(*last_added_, asr_from_robot, options_)) return;
  last_added_ = asr_from_robot;
  undrawn_.emplace_back(reading, asr_from_robot);
}

void LiveGrid::begin() {
  begun_ = std::async(std::launch::async, [this, sweeps = std::exchange(undrawn_, {})] {
    HimmGrid grid(options_.cell_m);
    draw(sweeps, grid);
    return grid;
  });
}

const HimmGrid& LiveGrid::grid() {
  if (begun_.valid()) grid_ = begun_.get();
  draw(std::exchange(undrawn_, {}), grid_);
  return grid_;
}

void LiveGrid::draw(const Sweeps& sweeps, HimmGrid& grid) const {
  for (const auto& [reading, asr_from_robot] : sweeps) {
    std::int64_t ignored = 0;
    grid.add_sweep(rays_of(reading, asr_from_robot, ray_options(options_), ignored));
    grid.mark_robot(asr_from_robot, footprint_);
  }
}

}  // namespace roomatlas
