// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/draft/wall_faces.hpp"

namespace roomatlas {

/// What was seen of walls on a face's line, whichever way they look: stretches along the face,
/// ascending; those of one face do not overlap, those of two may.
/// @param min_face_m faces with less support do not count
[[nodiscard]] std::vector<Interval> on_line(const WallFace& face,
                                            const std::vector<WallFace>& faces, double min_face_m);

/// How much wall was seen on a face's line, up to gaps of 4 m: what is farther is another wall's.
[[nodiscard]] double line_support_m(const WallFace& face, const std::vector<WallFace>& faces);

/// The same however far apart, which lie within a distance of the line.
[[nodiscard]] double seen_on_line_m(const WallFace& face, const std::vector<WallFace>& faces,
                                    double within_m);

}  // namespace roomatlas
