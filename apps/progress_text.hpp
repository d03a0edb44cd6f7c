// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace roomatlas::apps {

/// "match rooms 45 %, 12 s left": what a stage that works for `elapsed_s` has done. Time is told
/// from a second on: before, and before a fiftieth is done, no guess of the rest is worth a word.
/// @param done in [0, 1]; negative where nobody knows: then how long it works already is told
[[nodiscard]] std::string progress_text(const std::string& stage, double done, double elapsed_s);

/// A duration for people: "8 s", "3 min 20 s", "2 h 5 min".
[[nodiscard]] std::string duration_text(double duration_s);

}  // namespace roomatlas::apps
