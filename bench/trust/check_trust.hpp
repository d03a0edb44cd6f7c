// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "trust_samples.hpp"

namespace roomatlas::bench {

/// Markdown: what share was right of the maps, and of the visits, of which the program said so and
/// so much (a reliability table), how many error bars hold, and every wrong map that was given 95 %
/// or more.
[[nodiscard]] std::string trust_tables(const std::vector<TrustSample>& samples);

}  // namespace roomatlas::bench
