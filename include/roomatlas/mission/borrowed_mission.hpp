// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/mission/mission.hpp"

namespace roomatlas {

/// A mission that goes on being somebody else's: for who wants to own one, and for those that
/// change its events alone. The mission must outlive it.
class BorrowedMission : public MissionSource {
 public:
  explicit BorrowedMission(MissionSource& mission) : mission_(mission) {}
  BorrowedMission(const BorrowedMission&) =
      delete;  // of one that borrows, too: it would be passed by
  BorrowedMission& operator=(const BorrowedMission&) = delete;
  [[nodiscard]] std::optional<MissionEvent> next() override { return mission_.next(); }
  [[nodiscard]] const MissionInfo& info() const override { return mission_.info(); }
  [[nodiscard]] double progress() const override { return mission_.progress(); }

 private:
  MissionSource& mission_;
};

}  // namespace roomatlas
