// SPDX-License-Identifier: GPL-3.0-or-later
#include "usable_store.hpp"

#include <string>
#include <vector>

#include "roomatlas/core/issue.hpp"

namespace roomatlas::apps {

void require_assembled(const GeoPackageStore& store) {
  if (store.has_assembly()) return;
  throw NotEnoughError(store.file().string() +
                       ": not assembled yet: run `roomatlas assemble` on it first");
}

void require_readings(const GeoPackageStore& store, const char* why) {
  const std::vector<AsrId> ids = store.ids();
  if (ids.empty()) {
    throw NotEnoughError(store.file().string() +
                         ": holds a finished map and no readings, expected a mission: " + why);
  }
  if (!store.get(ids.front(), AsrDetail::readings).readings.empty()) return;
  throw NotEnoughError(store.file().string() +
                       ": was stored without its readings; map the log again without "
                       "--no-keep-readings: " +
                       why);
}

}  // namespace roomatlas::apps
