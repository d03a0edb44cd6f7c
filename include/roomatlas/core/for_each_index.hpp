// SPDX-License-Identifier: GPL-3.0-or-later
// Work in several threads whose result does not depend on how many there are.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace roomatlas {

/// Threads that a stage may use: `jobs`, or as many as there are cores where it is 0 or less.
[[nodiscard]] std::size_t thread_count(int jobs);

/// Calls `body(i)` once for each i in [0, count), up to `jobs` of them at once (see
/// `thread_count`). Indices begin in ascending order, and the calling thread works, too: with one
/// job it does all, in order. Where each body writes what no other reads or writes, such as its own
/// element of a result, the outcome is the same for any number of jobs. Ends when all bodies have.
/// @param between called in the calling thread alone, before each of the bodies that run there,
///   with the number that have begun; may be empty. To give up, it throws
/// @throws what a body threw, that of the lowest index where several did, or what `between` threw.
///   No other index begins then, and those that run end first
void for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& body,
                    const std::function<void(std::size_t)>& between = {});

/// The results of `make(i)` for each i in [0, count), in that order; see `for_each_index`.
template <typename Result, typename Make>
[[nodiscard]] std::vector<Result> results_of(std::size_t count, int jobs, const Make& make,
                                             const std::function<void(std::size_t)>& between = {}) {
  std::vector<Result> results(count);
  for_each_index(
      count, jobs, [&](std::size_t i) { results[i] = make(i); }, between);
  return results;
}

}  // namespace roomatlas
