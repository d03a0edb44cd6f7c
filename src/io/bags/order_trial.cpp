// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/order_trial.hpp"

#include "roomatlas/match/scan_odometry.hpp"
#include "roomatlas/mission/borrowed_mission.hpp"

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
constexpr double kAllAroundRad = radians(350.0);  // it rotates
constexpr double kFarM = 6.0;                     // farther ends are blurred by anything
constexpr double kClearly = 0.02;                 // bits of blur less than as they were measured

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

/// Notes whether sweeps take time, which matching settles.
class Watched : public BorrowedMission {
 public:
  explicit Watched(BagSource& mission) : BorrowedMission(mission), mission_(mission) {}
  [[nodiscard]] std::optional<MissionEvent> next() override {
    auto event = BorrowedMission::next();
    if (event) {
      const auto* reading = std::get_if<RangeReading>(&*event);
      has_times_ = has_times_ || (reading != nullptr && reading->sweep_s != 0.0);
    }
    return event;
  }
  [[nodiscard]] bool has_times() const { return has_times_ || mission_.unrolled() > 0; }

 private:
  const BagSource& mission_;
  bool has_times_ = false;
};

struct Tried {
  std::vector<double> blurs;  ///< of each window, as far as matching holds
  bool has_times = false;
};

Tried tried(BagSource& mission) {
  Tried found;
  auto watched = std::make_unique<Watched>(mission);
  const Watched& watch = *watched;
  const auto matched = scan_odometry(std::move(watched));
  Blur blur;
  try {
    for (int sweeps = 1; sweeps <= kSweeps; ++sweeps) {
      const auto event = matched->next();
      if (!event) break;
      if (const auto* reading = std::get_if<RangeReading>(&*event)) blur.add(*reading);
      if (sweeps % kWindow == 0) found.blurs.push_back(std::exchange(blur, {}).bits());
    }
  } catch (const std::runtime_error&) {  // who maps it will say it
  }
  found.has_times = watch.has_times();
  return found;
}

double mean_of_first(const std::vector<double>& values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return sum / static_cast<double>(count);
}

}  // namespace

void choose_beam_order(TopicChoice& choice, const Survey& beginning, const OpenRecording& open,
                       const MissionOptions& options, const std::string& file) {
  const bool has_odometry = choice.odometry != TopicChoice::Odometry::none;
  if (!has_odometry) choice.beam_order = 0.0;  // what is told helps where it is true alone
  const TopicEvidence& laser = beginning.evidence[choice.scans.empty() ? 0 : choice.scans.front()];
  const bool is_one_laser = choice.scans.size() == 1 && laser.kind != MessageKind::cloud;
  if (!is_one_laser || (has_odometry && laser.view_rad < kAllAroundRad)) return;
  std::map<double, std::vector<double>> blurs;
  std::size_t windows = kSweeps;
  for (const double order : {1.0, 0.0, -1.0}) {
    TopicChoice with_order = choice;
    with_order.beam_order = order;
    BagSource mission(file, open(), options, std::move(with_order), beginning);
    Tried found = tried(mission);
    if (order == 1.0 && !found.has_times) return;
    windows = std::min(windows, found.blurs.size());
    blurs[order] = std::move(found.blurs);
  }
  if (windows < kLeastWindows) return;
  const auto blur = [&](double order) { return mean_of_first(blurs[order], windows); };
  double best = choice.beam_order;
  for (const double order : {1.0, 0.0, -1.0}) {
    if (blur(order) < blur(best)) best = order;
  }
  if (blur(choice.beam_order) - blur(best) < kClearly) return;
  choice.beam_order = best;
  choice.said += best > 0.0 ? ", beams put to their own times"
                 : best < 0.0
                     ? ", beams put to their own times, in the reverse of the order that "
                       "the messages tell (walls are sharper so)"
                     : ", beams taken as measured at once, not as the messages tell (walls "
                       "are sharper so)";
}

}  // namespace roomatlas::io
