// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the library with Python's lock (the GIL) released.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "roomatlas/core/progress.hpp"

namespace roomatlas::python {

/// Tells Python how far a stage is, and asks it for Ctrl-C: at most 20 times a second. Any thread
/// may call. What Python raises stops the work and is raised again by `raise_again`.
class Listener {
 public:
  /// @param callback None, or a function of the stage's name and its share in [0, 1] or None
  explicit Listener(pybind11::object callback) : callback_(std::move(callback)) {}

  [[nodiscard]] Progress progress() {
    return [this](const std::string& stage, double done) { return tell(stage, done); };
  }

  void raise_again() {
    if (raised_) throw pybind11::error_already_set(*raised_);
  }

 private:
  bool tell(const std::string& stage, double done) {
    const std::lock_guard alone(mutex_);
    if (raised_) return false;
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < std::chrono::milliseconds(50)) return true;
    told_ = now;
    const pybind11::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (!callback_.is_none()) {
        callback_(stage, done < 0.0 ? std::nullopt : std::optional<double>(done));
      }
    } catch (const pybind11::error_already_set& error) {
      raised_.emplace(error);
    }
    return !raised_;
  }

  pybind11::object callback_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point told_;
  std::optional<pybind11::error_already_set> raised_;
};

/// `work(progress)` without the lock. Nothing of Python may be touched in it but through
/// `progress`.
template <typename Work>
auto without_lock(const pybind11::object& callback, Work work) {
  Listener listener(callback);
  try {
    const pybind11::gil_scoped_release released;
    return work(listener.progress());
  } catch (const Interrupted&) {
    listener.raise_again();
    throw;
  }
}

}  // namespace roomatlas::python
