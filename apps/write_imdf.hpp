// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "roomatlas/io/plans/imdf.hpp"

namespace roomatlas::apps {

/// Writes the archive, and warns of what it has instead of what was not said: a place on earth, an
/// address. @param options without the place
void write_imdf(const std::filesystem::path& file, const FloorPlan& plan,
                const std::optional<GeoReference>& on_earth, ImdfOptions options);

}  // namespace roomatlas::apps
