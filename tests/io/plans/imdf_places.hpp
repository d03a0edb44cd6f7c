// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imdf_rules.hpp"

namespace roomatlas::test::imdf {

/// Adds a sentence for each feature that does not lie where it must: in its venue or level, on the
/// boundary of a unit, beside other units.
void check_imdf_places(const ImdfFiles& files, std::vector<std::string>& broken);

}  // namespace roomatlas::test::imdf
