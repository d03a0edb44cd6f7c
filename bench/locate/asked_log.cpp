// SPDX-License-Identifier: GPL-3.0-or-later
#include "asked_log.hpp"

#include <memory>
#include <optional>
#include <span>

#include "roomatlas/io/logs/open_mission.hpp"
#include "roomatlas/pipeline/map_mission.hpp"

namespace roomatlas::bench {
namespace {

class Piece : public MissionSource {
 public:
  Piece(const std::vector<RangeReading>& readings, const TimeRange& range, MissionInfo info)
      : readings_(readings), range_(range), info_(std::move(info)) {}

  [[nodiscard]] std::optional<MissionEvent> next() override {
    for (; at_ < readings_.size(); ++at_) {
      const double time_s = readings_[at_].timestamp_s;
      if (time_s >= range_.from_s && time_s <= range_.to_s) return readings_[at_++];
    }
    return std::nullopt;
  }
  [[nodiscard]] const MissionInfo& info() const override { return info_; }
  [[nodiscard]] double progress() const override { return -1.0; }

 private:
  const std::vector<RangeReading>& readings_;
  TimeRange range_;
  MissionInfo info_;
  std::size_t at_ = 0;
};

}  // namespace

AskedLog::AskedLog(const std::filesystem::path& file) {
  const std::unique_ptr<MissionSource> mission = open_mission_to_map(file, {});
  while (const std::optional<MissionEvent> event = mission->next()) {
    if (const auto* reading = std::get_if<RangeReading>(&*event)) readings_.push_back(*reading);
  }
  info_ = mission->info();
}

MemoryStore AskedLog::mapped(const TimeRange& range, const MapOptions& options) const {
  MemoryStore store;
  Piece piece(readings_, range, info_);
  (void)map_mission(piece, store, options);
  return store;
}

}  // namespace roomatlas::bench
