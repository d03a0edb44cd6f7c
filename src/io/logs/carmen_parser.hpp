// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "carmen_message.hpp"

#include <string_view>

namespace roomatlas::io {

/// Takes one line of a known tag apart: CARMEN's text log format, and the same lines without their
/// end (no timestamp), which some tools write. Reuses the message's memory.
/// @param line without its line end; begins with `tag`'s name
/// @return nothing when all is well. A problem's message says what was found and expected; the
///   message is then unusable.
[[nodiscard]] std::optional<CarmenProblem> parse_carmen_line(const CarmenTag& tag,
                                                             std::string_view line,
                                                             CarmenMessage& message);

}  // namespace roomatlas::io
