// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/core/for_each_index.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace roomatlas {
namespace {

/// Indices handed out one by one, and what went wrong.
class Indices {
 public:
  explicit Indices(std::size_t count) : count_(count) {}

  /// The next one; nothing where all have begun, or one has failed.
  [[nodiscard]] std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (begun_ == count_ || failure_) return std::nullopt;
    return begun_++;
  }
  /// Keeps the failure of the lowest index: all below it had begun before it, so that it is the
  /// same one however the threads ran.
  void fail(std::size_t index, const std::exception_ptr& failure) {
    const std::lock_guard lock(mutex_);
    if (failure_ && failed_ <= index) return;
    failed_ = index;
    failure_ = failure;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::size_t count_;
  std::mutex mutex_;
  std::size_t begun_ = 0;
  std::size_t failed_ = 0;
  std::exception_ptr failure_;
};

void work(Indices& indices, const std::function<void(std::size_t)>& body,
          const std::function<void(std::size_t)>& between) {
  while (const auto index = indices.next()) {
    try {
      if (between) between(*index);
      body(*index);
    } catch (...) {
      indices.fail(*index, std::current_exception());
    }
  }
}

}  // namespace

std::size_t thread_count(int jobs) {
  if (jobs > 0) return static_cast<std::size_t>(jobs);
  return std::max(1U, std::thread::hardware_concurrency());
}

void for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& body,
                    const std::function<void(std::size_t)>& between) {
  Indices indices(count);
  const std::size_t threads = std::min(count, thread_count(jobs));
  {
    std::vector<std::jthread> others;  // join when they go
    for (std::size_t i = 1; i < threads; ++i) {
      others.emplace_back([&] { work(indices, body, {}); });
    }
    work(indices, body, between);
  }
  indices.rethrow();
}

}  // namespace roomatlas
