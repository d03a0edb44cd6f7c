// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace roomatlas::apps {

/// Warns of files in a folder of results that are called as results are and that this run did not
/// write: they are of an earlier one, with other options or of other missions.
/// @param written names in the folder; of a plan beside another, "beside/NAME"
void tell_earlier_results(const std::filesystem::path& folder,
                          const std::vector<std::string>& written);

}  // namespace roomatlas::apps
