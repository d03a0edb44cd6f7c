// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/place_inside.hpp"

namespace roomatlas::io {

std::filesystem::path place_inside(const std::filesystem::path& folder, const std::string& named) {
  const std::filesystem::path place = std::filesystem::path(named).lexically_normal();
  const bool leads_out = place.has_root_path() || (!place.empty() && *place.begin() == "..");
  return folder / (leads_out ? place.filename() : place);
}

}  // namespace roomatlas::io
