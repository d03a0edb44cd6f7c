// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {

/// All ASRs of a source, ascending by id.
[[nodiscard]] inline std::vector<Asr> load(const AsrSource& source, AsrDetail detail) {
  std::vector<Asr> asrs;
  for (const AsrId id : source.ids()) asrs.push_back(source.get(id, detail));
  return asrs;
}

/// One ASR with its readings. @throws InputError unless there is one for each pose
[[nodiscard]] inline Asr load_with_readings(const AsrSource& source, AsrId id) {
  Asr asr = source.get(id, AsrDetail::readings);
  if (asr.readings.size() != asr.path.size()) {
    throw InputError("ASR " + std::to_string(id) + " has " + std::to_string(asr.readings.size()) +
                     " readings, expected one for each of its " + std::to_string(asr.path.size()) +
                     " poses; map the log again");
  }
  return asr;
}

}  // namespace roomatlas
