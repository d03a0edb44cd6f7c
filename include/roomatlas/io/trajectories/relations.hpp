// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/evaluate/relations.hpp"
#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Relations, one `t1 t2 x y z roll pitch yaw` a line. Throws InputError naming file and line.
[[nodiscard]] std::vector<Relation> read_relations(const Path& file);

}  // namespace roomatlas
