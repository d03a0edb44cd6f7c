// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/correct/correct.hpp"
#include "roomatlas/graph/closures.hpp"
#include "roomatlas/pipeline/pipeline.hpp"

namespace roomatlas {

/// Matches every reading once more, from where the correction puts it, with the faces of its own
/// ASR and of all that a closure lays on it: the map and the path in turn make each other truer,
/// the expectation-maximization localization of the paper's section V. The frames stay.
/// @param shapes of all ASRs, parallel to `source.ids()`
/// @param closures those accepted tell which ASRs lie on each other
/// @returns one path an ASR, in its frame and one pose a reading; readings that match too little
///   keep their pose
[[nodiscard]] Paths feed_back(const AsrSource& source, const std::vector<AsrShape>& shapes,
                              const std::vector<Closure>& closures, const Placement& placement,
                              const FeedBackOptions& options);

}  // namespace roomatlas
