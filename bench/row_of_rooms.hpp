// SPDX-License-Identifier: GPL-3.0-or-later
// A mission through as many equal rooms in a row as one likes.
#pragma once

#include <cstdint>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas::bench {

inline constexpr double kRoomX = 6.0;  // metres, inside
inline constexpr double kRoomY = 5.0;
inline constexpr double kWall = 0.2;
inline constexpr double kPeriod = kRoomX + kWall;
inline constexpr double kDoor = 0.9;
inline constexpr int kVariants = 5;  // of the noise: rooms 1, 6, 11 ... get the same readings

inline Polygon box(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

/// Equal rooms in a row along x, joined by doors in the middle of their walls.
inline FloorPlan row_of_rooms(int rooms) {
  FloorPlan plan;
  const double end = rooms * kPeriod;
  plan.walls = {box(-kWall, -kWall, end, 0.0), box(-kWall, kRoomY, end, kRoomY + kWall)};
  for (int wall = 0; wall <= rooms; ++wall) {
    const double x = wall * kPeriod - kWall;
    const double half = wall == 0 || wall == rooms ? 0.0 : kDoor / 2.0;
    plan.walls.push_back(box(x, 0.0, x + kWall, kRoomY / 2.0 - half));
    plan.walls.push_back(box(x, kRoomY / 2.0 + half, x + kWall, kRoomY));
  }
  return plan;
}

/// The readings of one room, from just behind its door to just behind the next. The last step is
/// the first of the next room, moved by a room.
inline std::vector<SimulatedStep> steps_through_a_room(SimulationOptions options) {
  const double y = kRoomY / 2.0;
  const double x = kPeriod + 0.6;  // of the second of four rooms: both neighbours can be seen
  const Drive drive = {{x, y},       {x + 1.0, y},    {x + 1.8, y + 1.2}, {x + 3.6, y + 1.2},
                       {x + 4.4, y}, {x + kPeriod, y}};
  std::vector<SimulatedStep> steps;
  simulate(row_of_rooms(4), drive, options,
           [&](const SimulatedStep& step) { steps.push_back(step); });
  return steps;
}

/// The readings of very many equal rooms, of which a few are simulated.
class Row {
 public:
  explicit Row(SimulationOptions options = {}) {
    for (int i = 0; i < kVariants; ++i) {
      options.seed = static_cast<std::uint64_t>(i + 1);
      variants_.push_back(steps_through_a_room(options));
      // the same sensor throughout, as in one log
      for (SimulatedStep& step : variants_.back()) {
        step.reading.sensor = variants_.front().front().reading.sensor;
      }
    }
  }

  /// @param room from 1
  [[nodiscard]] const std::vector<SimulatedStep>& steps_in(int room) const {
    return variants_[static_cast<std::size_t>((room - 1) % kVariants)];
  }

 private:
  std::vector<std::vector<SimulatedStep>> variants_;
};

/// The readings of a mission along the row, one after the other; odometry goes on from room to
/// room.
class RowDrive {
 public:
  RowDrive(const Row& row, double period_s) : row_(row), period_s_(period_s) {}

  [[nodiscard]] int room() const { return room_; }  ///< of the next reading, from 1

  [[nodiscard]] RangeReading next() {
    const auto& steps = row_.steps_in(room_);
    RangeReading reading = steps[at_].reading;
    reading.timestamp_s = time_s_;
    reading.odom_from_robot = odom_from_robot_;
    odom_from_robot_ = odom_from_robot_ * (inverse(steps[at_].reading.odom_from_robot) *
                                           steps[at_ + 1].reading.odom_from_robot);
    time_s_ += period_s_;
    if (++at_ + 1 == steps.size()) {
      at_ = 0;
      ++room_;
    }
    return reading;
  }

 private:
  const Row& row_;
  double period_s_;
  Pose2 odom_from_robot_;
  double time_s_ = 1e9;
  int room_ = 1;
  std::size_t at_ = 0;
};

}  // namespace roomatlas::bench
