// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// How readings are matched once more where the correction puts them.
struct FeedBackOptions {
  bool enabled = true;
  ScanOptions scan;
  AlignOptions align{.first_gate_m = 0.12, .max_iterations = 4};  ///< nearly right already
  int max_points = 120;                                           ///< of a sweep
  double min_face_hits = 12.0;              ///< in one visit; fewer lie where noise put them
  double position_sigma_m = 0.05;           ///< of the pose in its own ASR ...
  double heading_sigma_rad = radians(2.0);  ///< ... and of its heading; smaller moves nothing
  int min_matched = 20;                     ///< fewer partners: the pose stays
  double min_matched_share = 0.3;           ///< so it does below this share of the sweep
};

/// Matches every reading once more, from where the correction puts it, with the faces of its own
/// ASR and of all that a closure lays on it: the map and the path in turn make each other truer,
/// the expectation-maximization localization of the paper's section V. The frames stay.
/// @param shapes of all ASRs, parallel to `source.ids()`
/// @param closures those accepted tell which ASRs lie on each other; those of other ASRs count for
///   nothing
/// @returns one path an ASR, in its frame and one pose a reading; readings that match too little
///   keep their pose
/// @param jobs threads at once, see `for_each_index`; so many ASRs' readings are loaded at a time
[[nodiscard]] Paths feed_back(const AsrSource& source, const std::vector<AsrShape>& shapes,
                              const std::vector<Closure>& closures, const Placement& placement,
                              const FeedBackOptions& options, int jobs = 1);

}  // namespace roomatlas
