// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"
#include "roomatlas/plan/floor_plan.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace roomatlas {

/// Errors of simulated wheel odometry. The defaults are the preset `mild`.
struct OdometryErrors {
  double length_share = 0.005;          ///< each driven length is reported longer by this share
  double heading_bias_deg_per_m = 0.1;  ///< constant drift over length
  double heading_noise_deg_per_sqrt_m = 1.0;  ///< random walk over length
  double turn_share = 0.0;                    ///< each turn is reported larger by this share
};

/// `mild`; `typical`: what a good robot does on carpet; `hard`: the worst recorded log we know
/// (3.3 deg/m, lengths short by 4 %, turns by 4 %).
enum class OdometryPreset { mild, typical, hard };
[[nodiscard]] OdometryErrors odometry_errors(OdometryPreset preset);

/// What goes wrong now and then, and what every robot has but no model of its noise. All rates 0:
/// nothing of it.
struct OdometryFaults {
  double slip_share = 0.0;  ///< of the driven length: wheels spin on stretches of half a metre,
                            ///< report half as much again, and turn by up to 20 degrees a metre
  double lag_s = 0.0;       ///< by which odometry is older than the ranges beside it
  double pushes_per_hour = 0.0;    ///< the robot is shoved and turned, and its wheels do not notice
  double push_m = 0.2;             ///< at most
  double push_deg = 15.0;          ///< at most, either way
  double dropouts_per_hour = 0.0;  ///< one wheel's encoder counts nothing for a while
  double dropout_s = 0.3;          ///< how long
};

struct SonarErrors {
  double range_noise_m = 0.02;       ///< standard deviation
  double dropout_share = 0.02;       ///< readings lost at random, [0, 1]
  double specular_limit_deg = 40.0;  ///< beyond this angle of incidence there is no echo
  double crosstalk_share = 0.005;    ///< readings in which a sonar hears its neighbour's ping, and
                                     ///< so the nearer of both echoes, [0, 1]
  double corner_echo_m = 1.0;        ///< how far a convex corner is heard from any angle; 0 hides
                                     ///< corners that point at the robot
};

struct LaserErrors {
  double range_noise_m = 0.01;   ///< standard deviation
  double dropout_share = 0.002;  ///< beams lost at random, [0, 1]
  double silent_share = 0.0;  ///< of the walls, in stretches of about 2 m: half of them are black
                              ///< and give no echo, half are glass, behind which it goes on
};

struct SimulationOptions {
  std::uint64_t seed = 1;                   ///< decides everything that is random
  double speed_m_per_s = 0.4;               ///< at most
  double turn_rate_deg_per_s = 45.0;        ///< at most
  double rate_hz = 10.0;                    ///< of odometry and of the sensor
  double start_timestamp_s = 1000000000.0;  ///< since 1970, of the first reading
  SensorKind sensor = SensorKind::sonar;
  double sonar_max_range_m = 5.0;  ///< at or beyond: no echo
  double sonar_cone_deg = 20.0;    ///< full opening angle; wider hears jambs earlier
  int sonars = 16;                 ///< in the ring, 3 to 16; few look ahead
  double laser_max_range_m = 8.0;  ///< at or beyond: no echo
  double laser_view_deg = 180.0;   ///< from the first beam to the last, (0, 360]
  int laser_beams = 181;           ///< evenly spread over the view, at least 2
  bool laser_behind = false;       ///< a second such laser looks back; both are one reading
  int people = 0;  ///< who walk about, are seen by the sensor and make way for the robot
  double moving_doors_share = 0.0;  ///< of the doors without a leaf: somebody slides them open and
                                    ///< shut; before the robot they are open
  RobotFootprint footprint;
  OdometryErrors odometry;
  OdometryFaults faults;
  SonarErrors sonar;
  LaserErrors laser;
};

/// A scripted drive: way-points in world metres, driven in straight lines and turns on the spot.
using Drive = std::vector<Point2>;

/// The first way-points of a drive, as many as are reached within `time_s`; two at least.
[[nodiscard]] Drive driven_within(Drive drive, double time_s, const SimulationOptions& options);

/// Of a person, who is round.
constexpr double kPersonRadius_m = 0.2;

struct OdometryStep {
  double timestamp_s = 0.0;
  Pose2 odom_from_robot;
  double speed_m_per_s = 0.0;
  double turn_rate_rad_per_s = 0.0;
};

struct SimulatedStep {
  OdometryStep odometry;
  RangeReading reading;
  TruePose truth;
  std::vector<Point2> people;  ///< where they stand, world metres; fewer where there is no place
};

/// The ring of the Pioneer 2: 16 sonars, 8 in front, 8 behind, at their real bearings
/// (+-90, +-50, +-30, +-10 degrees, and the same behind), on the rim of the robot.
[[nodiscard]] RangeSensor pioneer_sonar_ring(const SimulationOptions& options);

/// A ring of `options.sonars` on the rim of the robot, clockwise. Up to 8 look ahead, evenly from
/// 90 to -90 degrees; more are the Pioneer's front and the rest evenly behind; 16 are its whole
/// ring.
[[nodiscard]] RangeSensor sonar_ring(const SimulationOptions& options);

/// A laser scanner that looks ahead, on the robot's axis, 0.1 m ahead of its middle, by the
/// options' beams without width; where they say so, a second one as far behind it looks back.
[[nodiscard]] RangeSensor front_laser(const SimulationOptions& options);

/// The sensor that `options` choose.
[[nodiscard]] RangeSensor range_sensor(const SimulationOptions& options);

/// Drives the robot through the world and hands each step to `sink`, in order.
/// @param world walls, furniture and the leaves of open doors are obstacles; doors are gaps in the
///   walls
/// A robot that was pushed returns to the drive first.
/// Throws InputError when the drive has fewer than two points or passes through a wall (it names
/// the leg).
void simulate(const FloorPlan& world, const Drive& drive, const SimulationOptions& options,
              const std::function<void(const SimulatedStep&)>& sink);

}  // namespace roomatlas
