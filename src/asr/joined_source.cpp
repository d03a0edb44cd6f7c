// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/asr/joined_source.hpp"

#include <algorithm>
#include <utility>

#include "roomatlas/core/issue.hpp"

namespace roomatlas {

JoinedSource::JoinedSource(const std::vector<const AsrSource*>& sources) {
  AsrId offset = 0;
  for (const AsrSource* source : sources) {
    const std::vector<AsrId> ids = source->ids();
    const AsrId last = offset + (ids.empty() ? 0 : ids.back());
    parts_.push_back({source, offset, last});
    offset = last;
  }
}

std::vector<AsrId> JoinedSource::ids() const {
  std::vector<AsrId> all;
  for (const Part& part : parts_) {
    for (const AsrId id : part.source->ids()) all.push_back(id + part.offset);
  }
  return all;
}

std::vector<TruePose> JoinedSource::truth() const {
  std::vector<TruePose> all;
  for (const Part& part : parts_) {
    const std::vector<TruePose> own = part.source->truth();
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

Asr JoinedSource::get(AsrId id, AsrDetail detail) const {
  const auto part =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& one) { return id <= one.last; });
  if (part == parts_.end()) throw InputError("there is no ASR " + std::to_string(id));
  Asr asr = part->source->get(id - part->offset, detail);
  asr.id = id;
  for (Exit& exit : asr.exits) {
    if (exit.neighbor) *exit.neighbor += part->offset;
  }
  return asr;
}

SelectedAsrs without(const AsrSource& source, const std::set<AsrId>& some) {
  std::vector<AsrId> others = source.ids();
  std::erase_if(others, [&](AsrId id) { return some.contains(id); });
  return {source, std::move(others)};
}

}  // namespace roomatlas
