// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/record_again.hpp"

#include <memory>

namespace roomatlas {
namespace {

/// Believes the poses that it is given: somebody else has found them.
class GivenPoses : public Localizer {
 public:
  void clear() override {}
  void add(const RangeReading&, const Pose2&) override {}
  [[nodiscard]] Pose2 locate(const RangeReading&, const Pose2& predicted_asr_from_robot,
                             const Pose2&) override {
    return predicted_asr_from_robot;
  }
  [[nodiscard]] bool localizes(const RangeReading&) const override { return true; }
};

}  // namespace

RecordedAgain record_again(const std::vector<RangeReading>& readings,
                           const std::vector<Pose2>& map_from_robot,
                           const RobotFootprint& footprint, const RecorderOptions& options) {
  RecordedAgain again;
  AsrRecorder recorder(options, footprint, again.asrs, std::make_unique<GivenPoses>());
  for (std::size_t i = 0; i < readings.size(); ++i) recorder.add(readings[i], map_from_robot[i]);
  recorder.finish();
  std::size_t first = 0;  // reading of the ASR
  for (const Asr& asr : again.asrs.asrs) {
    again.placement[asr.id] = map_from_robot[first] * inverse(asr.path.front().asr_from_robot);
    first += asr.path.size();
  }
  return again;
}

}  // namespace roomatlas
