// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <type_traits>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/path.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::apps {

/// What `read` finds in a store; nothing where the file is missing or no store, or `read` throws an
/// InputError: whoever replaces it keeps one that cannot be read.
template <typename Read>
[[nodiscard]] auto read_if_possible(const Path& file, Read read)
    -> std::optional<std::invoke_result_t<Read, const GeoPackageStore&>> {
  try {
    return read(GeoPackageStore(file, GeoPackageStore::Mode::read));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// @throws NotEnoughError where the store is not assembled
void require_assembled(const GeoPackageStore& store);
/// @param why the command needs them: the end of a sentence
/// @throws NotEnoughError where it was stored without readings, or holds a finished map
void require_readings(const GeoPackageStore& store, const char* why);

}  // namespace roomatlas::apps
