// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace roomatlas {

using Path = std::filesystem::path;

}  // namespace roomatlas
