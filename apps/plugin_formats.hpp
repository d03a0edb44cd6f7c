// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/io/files/path.hpp"

namespace roomatlas::apps {

/// Of formats that nobody asked for by name, those that can be written here; of the others it says
/// which package brings them, or that the store's plan is too large.
[[nodiscard]] std::vector<std::string> possible_formats(const std::vector<std::string>& formats,
                                                        const Path& store);

/// The drawing as a picture beside it; where that cannot be, it says what is missing.
void write_picture(const Path& png, const std::string& svg, double dots_per_inch);

}  // namespace roomatlas::apps
