// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/with_paths.hpp"

namespace roomatlas {

Asr WithPaths::get(AsrId id, AsrDetail detail) const {
  Asr asr = source_.get(id, detail);
  const auto path = paths_.find(id);
  if (path == paths_.end() || asr.path.empty()) return asr;
  for (std::size_t i = 0; i < asr.path.size(); ++i) asr.path[i].asr_from_robot = path->second[i];
  return asr;
}

}  // namespace roomatlas
