// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace roomatlas::python {

/// `optimize` of a file (g2o, TORO), and of edges as arrays.
void bind_pose_graphs(pybind11::module_& core);

}  // namespace roomatlas::python
