// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "store_metadata.hpp"

namespace roomatlas::apps {

/// True when two configurations (TOML) agree in all that reading and mapping a log uses.
[[nodiscard]] bool map_alike(const std::string& one, const std::string& other);

// The settings with what a store was made with. What this run was given wins; what this version
// cannot read is named in a warning and is as in `settings`, as it is where the store kept no
// configuration.

/// With what the store's rooms were mapped with.
[[nodiscard]] Settings as_mapped(const Settings& settings, const Metadata& metadata,
                                 const std::filesystem::path& store);
/// With what the store was corrected with.
[[nodiscard]] Settings as_corrected(const Settings& settings, const Metadata& metadata,
                                    const std::filesystem::path& store);
/// With all that was set when the mission was mapped: for an assembly that is to follow. What an
/// earlier assembly was given was for that one alone.
[[nodiscard]] Settings as_recorded(const Settings& settings, const Metadata& metadata,
                                   const std::filesystem::path& store);

}  // namespace roomatlas::apps
