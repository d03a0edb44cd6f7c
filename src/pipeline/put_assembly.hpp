// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "roomatlas/assembly/assembly_store.hpp"

namespace roomatlas {

/// Gives the rooms the numbers and names that they had before, and puts all of it at once.
void put_with_former_rooms(AssemblyStore& store, const std::string& configuration,
                           Assembly& assembly);

}  // namespace roomatlas
