// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>

#include "parameter_list.hpp"

namespace roomatlas::apps {
namespace {

void add_faults(ParameterList& stage, OdometryFaults& faults) {
  stage.add("odometry-slip", faults.slip_share,
            "share of the driven length on which wheels spin, half a metre at a time", 0.0, 1.0);
  stage.add("odometry-lag", faults.lag_s, "s; by which odometry is older than ranges", 0.0, 10.0);
  stage.add("pushes", faults.pushes_per_hour,
            "an hour; the robot is shoved, and its wheels do not notice", 0.0, 3600.0);
  stage.add("push-length", faults.push_m, "m; of a push, at most", 0.0, 10.0);
  stage.add("push-turn", faults.push_deg, "deg; of a push, at most, either way", 0.0, 180.0);
  stage.add("encoder-dropouts", faults.dropouts_per_hour,
            "an hour; one wheel's encoder counts nothing for a while", 0.0, 3600.0);
  stage.add("encoder-dropout-time", faults.dropout_s, "s; how long", 0.0, 60.0);
}

}  // namespace

void add_simulation(Parameters& all, Settings& settings) {
  SimulationOptions& simulation = settings.simulation;
  ParameterList stage(all, Stage::simulation);
  stage.add("seed", simulation.seed, "decides everything that is random", 0.0, kLargestSeed);
  stage.choice("sensor", simulation.sensor, "ring of sonars, or laser",
               std::map<std::string, SensorKind>{{"sonar", SensorKind::sonar},
                                                 {"laser", SensorKind::laser}});
  stage.add("speed", simulation.speed_m_per_s, "m/s", 0.01, 10.0);
  // The preset stands before what it sets, so that single values win over it.
  const std::map<std::string, OdometryPreset> presets = {{"mild", OdometryPreset::mild},
                                                         {"typical", OdometryPreset::typical},
                                                         {"hard", OdometryPreset::hard}};
  stage.preset("odometry", presets, "errors of odometry; the options below change single ones",
               [&](OdometryPreset preset) { simulation.odometry = odometry_errors(preset); });
  stage.add("odometry-length-error", simulation.odometry.length_share,
            "share by which odometry reports lengths longer", -0.5, 0.5);
  stage.add("odometry-bias", simulation.odometry.heading_bias_deg_per_m, "deg/m; constant drift",
            -45.0, 45.0);
  stage.add("odometry-noise", simulation.odometry.heading_noise_deg_per_sqrt_m,
            "deg/sqrt(m); random walk of the heading", 0.0, 45.0);
  stage.add("odometry-turn-error", simulation.odometry.turn_share,
            "share by which odometry reports turns larger", -0.5, 0.5);
  add_faults(stage, simulation.faults);
  stage.add("sonars", simulation.sonars, "in the ring; up to 8 look ahead, 16 are a Pioneer's", 3,
            16);
  stage.add("sonar-range", simulation.sonar_max_range_m,
            "m; simulated sonars hear nothing at or beyond it", 0.5, 100.0);
  stage.add("sonar-opening", simulation.sonar_cone_deg,
            "deg; full opening angle of a simulated sonar", 0.0, 90.0);
  stage.add("laser-range", simulation.laser_max_range_m,
            "m; a simulated laser sees nothing at or beyond it", 0.5, 1000.0);
  stage.add("laser-view", simulation.laser_view_deg, "deg; from the first beam to the last", 1.0,
            360.0);
  stage.add("laser-beams", simulation.laser_beams, "evenly spread over the view", 2, 10000);
  stage.flag("laser-behind", simulation.laser_behind, "a second such laser looks back");
  stage.add("laser-silent-walls", simulation.laser.silent_share,
            "share of the walls, in stretches of 2 m, that are black or glass", 0.0, 1.0);
  stage.add("sonar-noise", simulation.sonar.range_noise_m, "m; standard deviation of a range", 0.0,
            1.0);
  stage.add("sonar-dropout", simulation.sonar.dropout_share, "share of lost echoes", 0.0, 1.0);
  stage.add("sonar-specular", simulation.sonar.specular_limit_deg,
            "deg; no echo from walls hit at a flatter angle of incidence", 0.0, 90.0);
  stage.add("sonar-crosstalk", simulation.sonar.crosstalk_share,
            "share of readings in which a sonar hears its neighbour's echo", 0.0, 1.0);
  stage.add("sonar-corner", simulation.sonar.corner_echo_m,
            "m; convex corners are heard from any angle up to here", 0.0, 100.0);
  stage.add("laser-noise", simulation.laser.range_noise_m, "m; standard deviation of a range", 0.0,
            1.0);
  stage.add("laser-dropout", simulation.laser.dropout_share, "share of lost beams", 0.0, 1.0);
  stage.add("people", simulation.people,
            "how many walk about, are seen by the sensor and make way for the robot", 0.0, 1000.0);
  stage.add("moving-doors", simulation.moving_doors_share,
            "share of the doors that somebody slides open and shut", 0.0, 1.0);
  stage.add("max-time", settings.explore.max_time_s,
            "s; the robot's own drive, or a tour, ends then", 1.0, 1e6);
  stage.choice("explore-on", settings.explore.on_odometry,
               "the pose that the exploring robot believes",
               std::map<std::string, bool>{{"truth", false}, {"odometry", true}});
}

}  // namespace roomatlas::apps
