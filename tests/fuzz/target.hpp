// SPDX-License-Identifier: GPL-3.0-or-later
// What is fuzzed: readers, each with inputs of our own making to begin with. The same targets are
// guided by coverage (`./run fuzz`, clang's libFuzzer) and replayed with a fixed number of seeded
// mutations by the tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "roomatlas/io/files/path.hpp"

namespace roomatlas::fuzz {

struct Target {
  std::string name;       ///< "mcap"
  std::string file_name;  ///< by which the reader sees its input
  std::function<std::vector<std::string>()> seeds;
  /// Reads all there is. Throws what a reader may throw: InputError, NotEnoughError, UsageError.
  std::function<void(const Path& file, const std::string& bytes)> read;
  /// Inputs of about a megabyte, which are replayed only.
  std::function<std::vector<std::string>()> large = [] { return std::vector<std::string>(); };
};

[[nodiscard]] const std::vector<Target>& all_targets();
/// Throws UsageError with all names.
[[nodiscard]] const Target& target_named(const std::string& name);

// By the families of formats.
[[nodiscard]] std::vector<Target> log_targets();
[[nodiscard]] std::vector<Target> recording_targets();
[[nodiscard]] std::vector<Target> message_targets();
[[nodiscard]] std::vector<Target> table_targets();
[[nodiscard]] std::vector<Target> plan_targets();
[[nodiscard]] std::vector<Target> picture_targets();
[[nodiscard]] std::vector<Target> store_targets();
[[nodiscard]] std::vector<Target> configuration_targets();

/// The families that a program has.
[[nodiscard]] std::vector<std::vector<Target>> families();

/// Gives the bytes to the reader. An error that a reader may not have, or that does not name the
/// file, ends the program.
void run_input(const Target& target, const std::string& bytes);

/// What a writer of ours leaves in a file of this name.
[[nodiscard]] std::string written(const std::string& file_name,
                                  const std::function<void(const Path& file)>& write);
/// Poses as trajectory files have them.
[[nodiscard]] std::vector<std::string> pose_seeds();
/// A file of the project's own data.
[[nodiscard]] std::string shipped(const std::string& file);

}  // namespace roomatlas::fuzz
