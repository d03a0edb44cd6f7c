// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ogrsf_frmts.h>

#include <memory>

#include "plugins/vector_file.hpp"

namespace roomatlas::ogr {

/// Our shape as one of OGR's.
[[nodiscard]] std::unique_ptr<OGRGeometry> to_ogr(const io::VectorShape& shape);

}  // namespace roomatlas::ogr
