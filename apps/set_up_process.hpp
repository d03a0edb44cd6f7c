// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace roomatlas::apps {

/// What a program does before all else: standard streams that a caller has closed, signals, memory
/// and the words of libraries.
/// @param program its name, as it was called
void set_up_process(const char* program);

}  // namespace roomatlas::apps
