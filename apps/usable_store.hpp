// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::apps {

/// @throws NotEnoughError where the store is not assembled
void require_assembled(const GeoPackageStore& store);
/// @param why the command needs them: the end of a sentence
/// @throws NotEnoughError where it was stored without readings, or holds a finished map
void require_readings(const GeoPackageStore& store, const char* why);

}  // namespace roomatlas::apps
