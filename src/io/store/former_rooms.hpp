// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.hpp"

namespace roomatlas {

/// Makes the table `former_rooms`: the rooms of the store that this one replaces, until an
/// assembly has carried their numbers and names over. Not transactional.
void create_former_rooms(Database& database);

}  // namespace roomatlas
