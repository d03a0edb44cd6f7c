// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "random_stream.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/simulate/simulate.hpp"

namespace roomatlas {

/// Doors that somebody opens and shuts: a leaf slides along the door line from one jamb, stands for
/// 10 to 90 s, shut, open or in between, and goes on. Where the robot comes near, it slides open in
/// time, so that nobody is ever in the way.
class SlidingDoors {
 public:
  SlidingDoors(const FloorPlan& world, const SimulationOptions& options);

  /// One period of the clock.
  /// @param robot where it is now
  void step(const Point2& robot);

  /// What stops a beam: a line for each door that is not open.
  [[nodiscard]] std::vector<Segment2> edges() const;

 private:
  struct Leaf {
    Segment2 line;  ///< from the jamb out of which it comes
    double shut_m = 0.0;
    double wanted_m = 0.0;
    double pause_s = 0.0;
  };
  [[nodiscard]] double between(double low, double high);

  double period_s_;
  RandomStream random_;
  std::vector<Leaf> leaves_;
};

}  // namespace roomatlas
