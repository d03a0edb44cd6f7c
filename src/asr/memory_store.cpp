// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/memory_store.hpp"

#include <algorithm>

#include "roomatlas/core/issue.hpp"

namespace roomatlas {

std::vector<AsrId> MemoryStore::ids() const {
  std::vector<AsrId> found;
  for (const Asr& asr : asrs) found.push_back(asr.id);
  std::sort(found.begin(), found.end());
  return found;
}

Asr MemoryStore::get(AsrId id, AsrDetail detail) const {
  const auto found =
      std::find_if(asrs.begin(), asrs.end(), [&](const Asr& asr) { return asr.id == id; });
  if (found == asrs.end()) throw InputError("there is no ASR " + std::to_string(id));
  Asr asr = *found;
  if (detail == AsrDetail::geometry) asr.path.clear();
  if (detail != AsrDetail::readings) asr.readings.clear();
  return asr;
}

}  // namespace roomatlas
