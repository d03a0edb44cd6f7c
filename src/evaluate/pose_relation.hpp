// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/evaluate/ape_rpe.hpp"

namespace roomatlas::evaluation {

/// The part of an error pose that counts; not for the two relations of point distances.
[[nodiscard]] double size_of(const Pose2& error, PoseRelation relation);

}  // namespace roomatlas::evaluation
