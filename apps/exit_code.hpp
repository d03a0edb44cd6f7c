// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace roomatlas::apps {

/// Runs a program's work. What it throws is said on stderr and becomes the exit code.
/// @returns what `work` returns, else a code of `ExitCode`
int exit_code_of(const std::function<int()>& work);

}  // namespace roomatlas::apps
