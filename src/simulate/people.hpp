// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "random_stream.hpp"
#include "roomatlas/core/geometry.hpp"
#include "roomatlas/simulate/simulate.hpp"
#include "walk_ways.hpp"

namespace roomatlas {

/// People who walk about where the robot can get to: each goes some way through rooms and
/// corridors at 0.5 to 1.2 m/s, stops for a while and goes on elsewhere. They keep off walls and
/// furniture, wait for the robot, and step back where it comes near; one who cannot is gone, and
/// comes back where the robot is not. So nobody ever touches it. People do not see each other.
class People {
 public:
  People(const FloorPlan& world, const SimulationOptions& options, const Point2& robot);

  /// One period of the clock.
  /// @param robot where it is now
  void step(const Point2& robot);

  [[nodiscard]] std::vector<Point2> places() const;
  /// What stops a beam: twelve edges a person.
  [[nodiscard]] std::vector<Segment2> edges() const;

 private:
  struct Person {
    std::optional<Point2> at;  ///< nothing: out of sight
    double speed_m_per_s = 1.0;
    double pause_s = 0.0;  ///< to stand still
    Polyline way;          ///< to walk, the next point last
  };
  void appear(Person& person, const Point2& robot);
  void walk(Person& person, const Point2& robot);
  void step_back(Person& person, const Point2& robot);
  [[nodiscard]] double between(double low, double high);

  double period_s_;
  double touching_m_;  ///< between the middles of a person and the robot
  RandomStream random_;
  std::optional<WalkWays> ways_;  ///< none where nobody walks
  std::vector<Person> people_;
};

}  // namespace roomatlas
