// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database.hpp"

namespace roomatlas {

/// Makes the table `layer_styles`, which QGIS reads when it opens the layers: rooms tinted by kind
/// and labelled, walls filled, doors white, as on the drawing. Not transactional.
void create_layer_styles(Database& database);

}  // namespace roomatlas
