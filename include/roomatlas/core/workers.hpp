// SPDX-License-Identifier: GPL-3.0-or-later
// Who does the work of which each part can be done by any: threads, or processes that share it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {

/// The threads of this process. A subclass shares the work with other processes that run the same
/// stage on the same input: each makes some of the parts, and all get all of them, as bytes. What
/// comes out is the same for any number of processes and threads.
class Workers {
 public:
  /// @param jobs threads at once in this process, see `thread_count`
  Workers(int jobs = 1) : jobs_(jobs) {}  // NOLINT(google-explicit-constructor): a count will do
  virtual ~Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int jobs() const { return jobs_; }

  /// True where parts go from process to process as bytes.
  [[nodiscard]] virtual bool is_shared() const { return false; }
  /// The bytes of all parts. Each process calls it as often as the others, with the same count.
  /// @param jobs threads at once in this process; with one, a part may use several itself
  /// @param make the bytes of one part, the same in whichever process
  [[nodiscard]] virtual std::vector<std::string> shared(
      std::size_t count, int jobs, const std::function<std::string(std::size_t)>& make) const {
    return results_of<std::string>(count, jobs, make);
  }

 private:
  int jobs_;
};

}  // namespace roomatlas
