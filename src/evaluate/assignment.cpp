// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/evaluate/assignment.hpp"

#include <algorithm>
#include <limits>

namespace roomatlas {
namespace {

/// Grows an assignment row by row. The table is made square with weights 0; row and column `n`
/// stand for "none". Costs are negated weights.
class Assigner {
 public:
  Assigner(const WeightTable& weights, std::size_t n)
      : weights_(weights), n_(n), row_price_(n + 1), column_price_(n + 1), row_of_(n + 1, n) {}

  /// Gives `row` a column along the cheapest path of changes to the assignment so far.
  void add(std::size_t row) {
    std::vector<double> reach(n_ + 1, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> before(n_ + 1, n_);
    std::vector<bool> done(n_ + 1, false);
    row_of_[n_] = row;
    std::size_t column = n_;
    do {
      done[column] = true;
      column = step(column, reach, before, done);
    } while (row_of_[column] != n_);
    for (; column != n_; column = before[column]) row_of_[column] = row_of_[before[column]];
  }

  [[nodiscard]] const std::vector<std::size_t>& row_of() const { return row_of_; }

 private:
  [[nodiscard]] double cost(std::size_t row, std::size_t column) const {
    const bool known = row < weights_.size() && column < weights_[row].size();
    return known ? -std::max(weights_[row][column], 0.0) : 0.0;
  }

  /// Looks at all columns from the row that holds `column`; the nearest one not done is next.
  std::size_t step(std::size_t column, std::vector<double>& reach, std::vector<std::size_t>& before,
                   const std::vector<bool>& done) {
    const std::size_t row = row_of_[column];
    std::size_t nearest = n_;
    for (std::size_t j = 0; j < n_; ++j) {
      if (done[j]) continue;
      const double reduced = cost(row, j) - row_price_[row] - column_price_[j];
      if (reduced < reach[j]) {
        reach[j] = reduced;
        before[j] = column;
      }
      if (nearest == n_ || reach[j] < reach[nearest]) nearest = j;
    }
    const double advance = reach[nearest];
    for (std::size_t j = 0; j <= n_; ++j) {
      if (done[j]) {
        row_price_[row_of_[j]] += advance;
        column_price_[j] -= advance;
      } else {
        reach[j] -= advance;
      }
    }
    return nearest;
  }

  const WeightTable& weights_;
  std::size_t n_;
  std::vector<double> row_price_;
  std::vector<double> column_price_;
  std::vector<std::size_t> row_of_;  ///< of each column; n where it is free
};

}  // namespace

std::vector<std::optional<std::size_t>> best_assignment(const WeightTable& weights) {
  const std::size_t rows = weights.size();
  const std::size_t columns = rows == 0 ? 0 : weights.front().size();
  const std::size_t n = std::max(rows, columns);
  Assigner assigner(weights, n);
  for (std::size_t row = 0; row < n; ++row) assigner.add(row);
  std::vector<std::optional<std::size_t>> result(rows);
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t row = assigner.row_of()[column];
    if (row < rows && weights[row][column] > 0.0) result[row] = column;
  }
  return result;
}

}  // namespace roomatlas
