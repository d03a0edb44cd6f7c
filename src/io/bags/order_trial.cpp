// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/order_trial.hpp"

#include "roomatlas/match/scan_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace roomatlas::io {
namespace {

constexpr int kSweeps = 400;  // of the beginning that are tried
constexpr int kWindow = 40;   // sweeps whose walls are compared: matching drifts little in them
constexpr std::size_t kLeastWindows = 3;
constexpr double kCellM = 0.05;
constexpr double kFarM = 6.0;      // farther ends are blurred by anything
constexpr double kClearly = 0.02;  // bits of blur less than as they were measured

/// How the ends of some sweeps spread over cells: the entropy of their places, in bits.
class Blur {
 public:
  void add(const RangeReading& reading) {
    for (std::size_t i = 0; i < reading.ranges_m.size(); ++i) {
      const auto range_m = static_cast<double>(reading.ranges_m[i]);
      if (!(range_m > 0.0 && range_m < std::min(kFarM, reading.sensor->max_range_m))) continue;
      const Point2 end =
          reading.odom_from_robot * (reading.sensor->robot_from_beam[i] * Point2(range_m, 0.0));
      ++cells_[{std::llround(end.x() / kCellM), std::llround(end.y() / kCellM)}];
      ends_ += 1.0;
    }
  }
  [[nodiscard]] double bits() const {
    double bits = 0.0;
    for (const auto& [cell, ends] : cells_) {
      const double share = static_cast<double>(ends) / ends_;
      bits -= share * std::log2(share);
    }
    return bits;
  }

 private:
  std::map<std::pair<long long, long long>, int> cells_;
  double ends_ = 0.0;
};

/// Tells whether there is anything to try.
class Watched : public MissionSource {
 public:
  Watched(std::unique_ptr<MissionSource> mission, bool& has_times)
      : mission_(std::move(mission)), has_times_(has_times) {}
  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = mission_->next();
    if (event) {
      const auto* reading = std::get_if<RangeReading>(&*event);
      has_times_ = has_times_ || (reading != nullptr && reading->sweep_s != 0.0);
    }
    return event;
  }
  [[nodiscard]] const MissionInfo& info() const override { return mission_->info(); }
  [[nodiscard]] double progress() const override { return mission_->progress(); }

 private:
  std::unique_ptr<MissionSource> mission_;
  bool& has_times_;
};

/// The blur of each window, as far as matching holds.
std::vector<double> blurs_of(std::unique_ptr<MissionSource> mission, bool& has_times) {
  std::vector<double> blurs;
  const auto matched = scan_odometry(std::make_unique<Watched>(std::move(mission), has_times));
  Blur blur;
  try {
    for (int sweeps = 1; sweeps <= kSweeps; ++sweeps) {
      const auto event = matched->next();
      if (!event) break;
      if (const auto* reading = std::get_if<RangeReading>(&*event)) blur.add(*reading);
      if (sweeps % kWindow == 0) blurs.push_back(std::exchange(blur, {}).bits());
    }
  } catch (const std::runtime_error&) {  // who maps it will say it
  }
  return blurs;
}

double mean_of_first(const std::vector<double>& values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

}  // namespace

void choose_beam_order(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                       const MissionOptions& options, const std::string& file) {
  const bool is_one_laser = choice.scans.size() == 1 &&
                            beginning.evidence[choice.scans.front()].kind != MessageKind::cloud;
  if (choice.odometry != TopicChoice::Odometry::none || !is_one_laser) return;
  std::map<double, std::vector<double>> blurs;
  std::size_t windows = kSweeps;
  for (const double order : {1.0, 0.0, -1.0}) {
    TopicChoice tried = choice;
    tried.beam_order = order;
    bool has_times = false;
    blurs[order] = blurs_of(
        std::make_unique<BagSource>(file, open(), options, std::move(tried), beginning), has_times);
    if (order == 1.0 && !has_times) return;
    windows = std::min(windows, blurs[order].size());
  }
  if (windows < kLeastWindows) return;
  const auto blur = [&](double order) { return mean_of_first(blurs[order], windows); };
  const double best = blur(1.0) <= blur(-1.0) ? 1.0 : -1.0;
  if (blur(0.0) - blur(best) < kClearly) return;
  choice.beam_order = best;
  choice.said += best > 0.0 ? ", beams put to their own times"
                            : ", beams put to their own times, in the reverse of the order that "
                              "the messages tell (walls are sharper so)";
}

}  // namespace roomatlas::io
