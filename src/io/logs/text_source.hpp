// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "left_out_lines.hpp"
#include "spike_filter.hpp"
#include "text/line_reader.hpp"
#include "text/tokens.hpp"

#include "roomatlas/mission/mission.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace roomatlas::io {

/// What a log's line gave.
struct LineContent {
  std::string tag;                       ///< under which the line is counted
  std::string problem;                   ///< what was found and expected; the line is then left out
  std::optional<Pose2> odom_from_robot;  ///< odometry, for the path's length
  std::optional<double> timestamp_s;
  std::vector<float> ranges_m;  ///< empty: no reading
  std::int64_t line = 0;        ///< its number; `read` need not set it
};

/// A log of one laser with one message a line, streaming: the part that small formats share. What
/// is in a line is up to the format.
class TextSource : public MissionSource {
 public:
  TextSource(const std::filesystem::path& file, const MissionOptions& options, const char* format);

  [[nodiscard]] std::optional<MissionEvent> next() override;
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override { return reader_.progress(); }

 protected:
  /// Takes a line apart. A reading needs a pose: that on the line, else the latest before it.
  [[nodiscard]] virtual LineContent read(Tokens fields) = 0;

  void set_laser(std::shared_ptr<const RangeSensor> laser);
  [[nodiscard]] bool has_laser() const { return laser_ != nullptr; }
  void set_odometry(const char* source) { info_.odometry = source; }
  void set_has_times(bool has_times) { info_.has_times = has_times; }
  void warn(std::string field, std::string message);

 private:
  void take_line(std::string_view line);
  [[nodiscard]] std::optional<RangeReading> use_decided();
  [[nodiscard]] std::optional<RangeReading> use(const LineContent& content);
  void note_time(double timestamp_s);
  void leave_out(const std::string& tag, const std::string& problem);
  void note_end();

  LineReader reader_;
  std::int64_t line_ = 0;  ///< at work, for issues
  SpikeFilter<LineContent> spikes_;
  LeftOutLines left_out_;
  MissionInfo info_;
  std::shared_ptr<const RangeSensor> laser_;
  std::optional<Pose2> odom_from_robot_;
  bool ended_ = false;
};

/// A laser in the plane: beams counter-clockwise from `start_rad`, `step_rad` apart.
[[nodiscard]] std::shared_ptr<const RangeSensor> make_laser(const Pose2& robot_from_laser,
                                                            int beams, double start_rad,
                                                            double step_rad, double max_range_m);

/// Fields as numbers. `number` and `ranges` keep the first failure, which `problem` tells.
class NumberFields {
 public:
  explicit NumberFields(Tokens fields) : fields_(fields) {}
  double number(const char* field);
  Pose2 pose(double metres_per_unit);
  std::vector<float> ranges(int count, double metres_per_unit);
  /// Nothing may be left on the line.
  void end();
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  Tokens fields_;
  std::string problem_;
};

}  // namespace roomatlas::io
