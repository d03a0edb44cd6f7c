// SPDX-License-Identifier: GPL-3.0-or-later
// How sure the directions of heard walls are. All variances in rad^2.
#pragma once

#include "sonar_batch.hpp"

namespace roomatlas {

/// Of a wall's direction against the building's while the solution is sought.
[[nodiscard]] double sought_variance(const SeenWall& wall, const SonarBatchOptions& options);

/// The same of two that may be one.
[[nodiscard]] double sought_variance(const SeenWall& a, const SeenWall& b,
                                     const SonarBatchOptions& options);

/// The square of the scale at which Geman and McClure let go of a direction.
[[nodiscard]] double far_squared(double sought_variance);

/// How sure a wall that follows the building makes its node's heading: one over the variance,
/// 1/rad^2. At the solution long stretches whose returns lie on a line count far more than while it
/// is sought.
[[nodiscard]] double heading_information(const SeenWall& wall, const SonarBatchOptions& options);

}  // namespace roomatlas
