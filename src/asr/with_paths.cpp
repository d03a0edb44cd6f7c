// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/with_paths.hpp"

#include <stdexcept>
#include <string>

namespace roomatlas {

Asr WithPaths::get(AsrId id, AsrDetail detail) const {
  Asr asr = source_.get(id, detail);
  const auto path = paths_.find(id);
  if (path == paths_.end() || asr.path.empty()) return asr;
  if (path->second.size() != asr.path.size()) {
    throw std::invalid_argument("ASR " + std::to_string(id) + " has " +
                                std::to_string(asr.path.size()) + " poses, its path " +
                                std::to_string(path->second.size()));
  }
  for (std::size_t i = 0; i < asr.path.size(); ++i) asr.path[i].asr_from_robot = path->second[i];
  return asr;
}

}  // namespace roomatlas
