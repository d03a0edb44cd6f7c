// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/mission/plausible.hpp"
#include "small_logs.hpp"
#include "text/numbers.hpp"
#include "text_source.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas::io {
namespace {

constexpr double kCentimetre = 0.01;       // in metres
constexpr int kBeams = 180;                // a degree apart, from -90 degrees on
constexpr double kSameMounting_m = 0.005;  // poses are interpolated and printed to 10 nm

/// To a millimetre: the rest is how the poses were interpolated.
double rounded_m(double value_m) { return std::round(value_m * 1000.0) / 1000.0 + 0.0; }

class WeanSource : public TextSource {
 public:
  WeanSource(const std::filesystem::path& file, const MissionOptions& options)
      : TextSource(file, options, "Wean Hall"), max_range_m_(options.laser_max_range_m) {
    set_odometry("poses in scans");
  }

 private:
  /// O x y theta t | L x y theta laser_x laser_y laser_theta r1 .. r180 t
  LineContent read(Tokens fields) override {
    LineContent content;
    content.tag = std::string(fields.next());
    const bool is_scan = content.tag == "L";
    NumberFields numbers(fields);
    if (!is_scan && content.tag != "O") {
      content.problem = "expected a line that begins with O or L, found " + io::quoted(content.tag);
      return content;
    }
    const Pose2 odom_from_robot = numbers.pose(kCentimetre);
    Pose2 odom_from_laser;
    if (is_scan) {
      odom_from_laser = numbers.pose(kCentimetre);
      content.ranges_m = numbers.ranges(kBeams, kCentimetre);
    }
    content.timestamp_s = numbers.number("ts");
    numbers.end();
    content.problem = numbers.problem();
    if (!is_scan || !content.problem.empty()) return content;  // O lines lie between the scans'
    content.odom_from_robot = odom_from_robot;
    const Pose2 robot_from_laser = inverse(odom_from_robot) * odom_from_laser;
    const double apart_m = robot_from_laser.position().norm();
    if (apart_m > kFarthestMount_m) {
      content.problem = "expected the laser at most 10 m from the robot's centre, found it " +
                        shown(apart_m) + " m away";
      return content;
    }
    mount(robot_from_laser);
    return content;
  }

  void mount(const Pose2& robot_from_laser) {
    if (!has_laser()) {
      mounted_ = {rounded_m(robot_from_laser.x_m), rounded_m(robot_from_laser.y_m),
                  wrap_angle(robot_from_laser.theta_rad)};
      set_laser(make_laser(mounted_, kBeams, radians(-90.0), radians(1.0), max_range_m_));
    } else if ((robot_from_laser.position() - mounted_.position()).norm() > kSameMounting_m &&
               !moved_) {
      moved_ = true;
      warn("xl yl", "the laser sits elsewhere on the robot than in the first scan, which is kept");
    }
  }

  double max_range_m_;
  Pose2 mounted_;
  bool moved_ = false;
};

}  // namespace

std::unique_ptr<MissionSource> open_wean_log(const std::filesystem::path& file,
                                             const MissionOptions& options) {
  return std::make_unique<WeanSource>(file, options);
}

}  // namespace roomatlas::io
