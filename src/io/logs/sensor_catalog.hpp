// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carmen_message.hpp"
#include "carmen_parameters.hpp"

#include "roomatlas/mission/mission.hpp"

#include <memory>
#include <vector>

namespace roomatlas::io {

using SensorList = std::vector<std::shared_ptr<const RangeSensor>>;

/// Makes the sensors of a log, each geometry once. A sensor is the same as an earlier one while no
/// beam moves by more than 1 mm or turns by more than 1e-4 rad, so that the last digits of the
/// poses, from which the mounting is computed, do not matter.
class SensorCatalog {
 public:
  static constexpr std::size_t kMostSensors = 64;  ///< a new geometry then replaces the oldest

  /// @param sensors what the catalog knows, in order of appearance; outlives it
  SensorCatalog(const MissionOptions& options, SensorList& sensors)
      : options_(options), sensors_(sensors) {}

  /// The sensor that made this scan.
  /// @param poses_hold the scan's poses tell the mounting; else it is the tag's usual one
  [[nodiscard]] std::shared_ptr<const RangeSensor> sensor_of(const CarmenTag& tag,
                                                             const CarmenScan& scan,
                                                             const CarmenParameters& parameters,
                                                             bool poses_hold);

 private:
  void describe_laser(const CarmenTag& tag, const CarmenScan& scan,
                      const CarmenParameters& parameters, bool poses_hold);
  void describe_sonar(const CarmenScan& scan, const CarmenParameters& parameters);

  MissionOptions options_;
  SensorList& sensors_;
  RangeSensor wanted_;  ///< reused from scan to scan
};

/// Where a laser sits on the robot: from the two poses where they hold, rounded to 1 mm and
/// 1e-4 rad (quarter turns exactly), else from the parameters. A rear laser whose poses do not tell
/// its direction looks backwards.
[[nodiscard]] Pose2 robot_from_laser(const CarmenTag& tag, const CarmenScan& scan,
                                     const CarmenParameters& parameters, bool poses_hold);

/// Half the opening angle of a sonar, [0, pi/2). CARMEN writes the full angle in radians; one of pi
/// or more cannot be meant so and is read as degrees. Without an angle on the line: the option's.
[[nodiscard]] double half_cone_rad(double cone_on_line, const MissionOptions& options);

}  // namespace roomatlas::io
