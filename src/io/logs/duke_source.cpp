// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_logs.hpp"
#include "text_source.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

constexpr double kNoEcho_m = 8.1;  // the scanner's codes for "nothing seen" lie from here to 8.19
constexpr int kSickBeams = 181;    // -90 to 90 degrees, both included

class DukeSource : public TextSource {
 public:
  DukeSource(const std::filesystem::path& file, const MissionOptions& options)
      : TextSource(file, options, "DP-SLAM") {
    set_odometry("Odometry lines");
    set_has_times(false);
    set_laser(make_laser({}, kSickBeams, radians(-90.0), radians(1.0),
                         std::min(options.laser_max_range_m, kNoEcho_m)));
  }

 private:
  /// Odometry x y theta | Laser 181 r1 .. r181
  LineContent read(Tokens fields) override {
    LineContent content;
    content.tag = std::string(fields.next());
    NumberFields numbers(fields);
    if (content.tag == "Odometry") {
      content.odom_from_robot = numbers.pose(1.0);
    } else if (content.tag == "Laser") {
      const double count = numbers.number("number of readings");
      if (count != kSickBeams && numbers.problem().empty()) {
        content.problem = "Laser: expected 181 readings, found " + std::to_string(count);
        return content;
      }
      content.ranges_m = numbers.ranges(kSickBeams, 1.0);
    } else {
      content.problem =
          "expected a line that begins with Odometry or Laser, found " + io::quoted(content.tag);
      return content;
    }
    numbers.end();
    content.problem = numbers.problem();
    return content;
  }
};

}  // namespace

std::unique_ptr<MissionSource> open_duke_log(const std::filesystem::path& file,
                                             const MissionOptions& options) {
  return std::make_unique<DukeSource>(file, options);
}

}  // namespace roomatlas::io
