// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_logs.hpp"
#include "text_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomatlas::io {
namespace {

// The rover as tinySLAM describes it (Steux and El Hamzaoui, "CoreSLAM", ICARCV 2010).
constexpr double kWheelRadius_m = 0.077;
constexpr double kHalfAxle_m = 0.165;     // from the middle to a wheel
constexpr double kTicksPerTurn = 2000.0;  // of a wheel
constexpr double kLaserAhead_m = 0.145;   // of the axle
constexpr int kScannerBeams = 682;        // of the scanner ...
constexpr double kSweep_deg = 240.0;      // ... over this angle
constexpr int kFirstFree = 70;            // beams outside [first, last) see the rover itself
constexpr int kLastFree = 612;            // likewise
constexpr double kFarthest_m = 5.6;       // of the scanner
constexpr double kLeast_m = 0.02;         // less is one of its error codes

/// Two layouts, told apart by how many fields stand before the ranges.
struct Layout {
  std::size_t fields = 0;
  int left_field = 0;  ///< from 1
  int right_field = 0;
  double right_sign = 1.0;  ///< the wheel that is mounted the other way round counts backwards
};
/// As the two robots' logs have them.
constexpr Layout kLayouts[] = {{25 + kScannerBeams, 3, 4, 1.0}, {13 + kScannerBeams, 2, 3, -1.0}};

const Layout* layout_of(std::size_t fields) {
  const auto found = std::find_if(std::begin(kLayouts), std::end(kLayouts),
                                  [&](const Layout& layout) { return layout.fields == fields; });
  return found == std::end(kLayouts) ? nullptr : found;
}

class MinesSource : public TextSource {
 public:
  MinesSource(const std::filesystem::path& file, const MissionOptions& options)
      : TextSource(file, options, "tinySLAM") {
    set_odometry("wheel encoders");
    set_laser(make_laser({kLaserAhead_m, 0.0, 0.0}, kScannerBeams, radians(-kSweep_deg / 2.0),
                         radians(kSweep_deg) / (kScannerBeams - 1),
                         std::min(options.laser_max_range_m, kFarthest_m)));
  }

 private:
  LineContent read(Tokens fields) override {
    LineContent content;
    content.tag = "scan";
    const Layout* layout = layout_of(fields.count());
    if (layout == nullptr) {
      content.problem = "expected 695 or 707 fields, found " + std::to_string(fields.count());
      return content;
    }
    NumberFields numbers(fields);
    double left = 0.0;
    double right = 0.0;
    const int before_ranges = static_cast<int>(layout->fields) - kScannerBeams;
    for (int field = 1; field <= before_ranges; ++field) {
      const double value = numbers.number(field == 1 ? "time" : "encoder");
      if (field == 1) content.timestamp_s = value * 1e-6;
      if (field == layout->left_field) left = value;
      if (field == layout->right_field) right = layout->right_sign * value;
    }
    content.ranges_m = numbers.ranges(kScannerBeams, 1e-3);
    content.problem = numbers.problem();
    if (!content.problem.empty()) return content;
    drop_unusable(content.ranges_m);
    content.odom_from_robot = reckon(left, right);
    return content;
  }

  static void drop_unusable(std::vector<float>& ranges_m) {
    for (int i = 0; i < kScannerBeams; ++i) {
      float& range_m = ranges_m[static_cast<std::size_t>(i)];
      if (i < kFirstFree || i >= kLastFree || range_m < static_cast<float>(kLeast_m)) {
        range_m = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }

  /// Dead reckoning: an arc between two scans, driven along its chord. Starts at the origin.
  Pose2 reckon(double left_ticks, double right_ticks) {
    constexpr double kMetresPerTick = 2.0 * kPi * kWheelRadius_m / kTicksPerTurn;  // of a wheel
    if (has_ticks_) {
      const double left_m = (left_ticks - left_ticks_) * kMetresPerTick;
      const double right_m = (right_ticks - right_ticks_) * kMetresPerTick;
      const double turn_rad = (right_m - left_m) / (2.0 * kHalfAxle_m);
      const double arc_m = (left_m + right_m) / 2.0;
      const double half = turn_rad / 2.0;
      const double chord_m = half == 0.0 ? arc_m : arc_m * std::sin(half) / half;
      odom_from_robot_ = odom_from_robot_ * Pose2{chord_m * std::cos(half),
                                                  chord_m * std::sin(half), wrap_angle(turn_rad)};
    }
    has_ticks_ = true;
    left_ticks_ = left_ticks;
    right_ticks_ = right_ticks;
    return odom_from_robot_;
  }

  bool has_ticks_ = false;
  double left_ticks_ = 0.0;
  double right_ticks_ = 0.0;
  Pose2 odom_from_robot_;
};

}  // namespace

std::unique_ptr<MissionSource> open_mines_log(const std::filesystem::path& file,
                                              const MissionOptions& options) {
  return std::make_unique<MinesSource>(file, options);
}

}  // namespace roomatlas::io
