// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"

namespace roomatlas {

/// All ASRs of a source, ascending by id.
[[nodiscard]] inline std::vector<Asr> load(const AsrSource& source, AsrDetail detail) {
  std::vector<Asr> asrs;
  for (const AsrId id : source.ids()) asrs.push_back(source.get(id, detail));
  return asrs;
}

}  // namespace roomatlas
