// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/store.hpp"
#include "roomatlas/edit/edit.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

/// The options with the closures that statements reject or pin, where the visits are found.
[[nodiscard]] ClosureOptions with_edited_closures(const AsrSource& source,
                                                  const std::vector<Edit>& edits,
                                                  ClosureOptions options);

/// What became of them.
/// @param closures that were tried
/// @param are_sought false where missions of this kind have none
[[nodiscard]] Issues edited_closure_issues(const AsrSource& source, const std::vector<Edit>& edits,
                                           const std::vector<Closure>& closures, bool are_sought);

}  // namespace roomatlas
