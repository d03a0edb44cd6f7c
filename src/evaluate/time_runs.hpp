// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace roomatlas::evaluation {

/// Finds places in a list of times that may step back. Nothing is sorted: the list is cut into
/// runs in which time does not step back, and only inside a run is it searched by bisection.
/// Times that are not finite are passed over.
class TimeRuns {
 public:
  explicit TimeRuns(const std::vector<double>& times_s);

  /// Two neighbours in the list, `before` at or before the time and `after` at or after it; the
  /// same place twice where the time is met exactly.
  struct Bracket {
    std::size_t before = 0;
    std::size_t after = 0;
  };
  /// Of the first run that encloses the time, beginning with run `first` and going round.
  [[nodiscard]] std::optional<Bracket> enclosing(double time_s, std::size_t first = 0) const;
  /// The nearest in time; of equally near ones the first in the list.
  [[nodiscard]] std::optional<std::size_t> nearest(double time_s) const;
  /// The latest at or before the time; the earliest of all where none is.
  [[nodiscard]] std::optional<std::size_t> latest_before(double time_s) const;
  /// The first in the list that is the same to the microsecond, beginning with run `first`.
  [[nodiscard]] std::optional<std::size_t> same_microsecond(double time_s,
                                                            std::size_t first = 0) const;

  [[nodiscard]] std::size_t run_of(std::size_t place) const;
  [[nodiscard]] std::size_t runs() const { return runs_.size(); }

 private:
  struct Entry {
    double time_s = 0.0;
    std::size_t place = 0;
  };
  struct Run {
    std::size_t begin = 0;  ///< in `entries_`
    std::size_t end = 0;
  };
  /// The first entry of a run that is later than the time.
  [[nodiscard]] std::size_t after_in(const Run& run, double time_s) const;

  std::vector<Entry> entries_;
  std::vector<Run> runs_;
};

}  // namespace roomatlas::evaluation
