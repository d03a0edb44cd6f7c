// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/grid/cell_domain.hpp"

#include <algorithm>

namespace roomatlas {

CellDomain CellDomain::from_rows(int first_row, std::vector<std::vector<Span>> rows) {
  const auto is_used = [](const std::vector<Span>& row) { return !row.empty(); };
  const auto used = std::find_if(rows.begin(), rows.end(), is_used);
  first_row += static_cast<int>(used - rows.begin());
  rows.erase(rows.begin(), used);
  while (!rows.empty() && rows.back().empty()) rows.pop_back();
  if (rows.empty()) return {};
  auto numbered = std::make_shared<Rows>();
  numbered->begin.push_back(0);
  CellBox bounds{{rows.front().front().from, first_row},
                 {rows.front().front().to, first_row + static_cast<int>(rows.size())}};
  for (const std::vector<Span>& row : rows) {
    for (Span span : row) {
      span.first = numbered->count;
      numbered->count += static_cast<std::size_t>(span.to - span.from);
      bounds.min.x = std::min(bounds.min.x, span.from);
      bounds.max.x = std::max(bounds.max.x, span.to);
      numbered->spans.push_back(span);
    }
    numbered->begin.push_back(numbered->spans.size());
  }
  CellDomain domain(bounds);
  domain.rows_ = std::move(numbered);
  return domain;
}

CellDomain CellDomain::within(const CellBox& box) const {
  const CellBox common{{std::max(box.min.x, bounds_.min.x), std::max(box.min.y, bounds_.min.y)},
                       {std::min(box.max.x, bounds_.max.x), std::min(box.max.y, bounds_.max.y)}};
  if (common.width() <= 0 || common.height() <= 0) return {};
  if (rows_ == nullptr) return common;
  std::vector<std::vector<Span>> rows;
  for (int y = common.min.y; y < common.max.y; ++y) {
    std::vector<Span>& row = rows.emplace_back();
    for_each_span(y, [&](const Span& span) {
      const int from = std::max(span.from, common.min.x);
      const int to = std::min(span.to, common.max.x);
      if (from < to) row.push_back({from, to, 0});
    });
  }
  return from_rows(common.min.y, std::move(rows));
}

bool CellDomain::operator==(const CellDomain& other) const {
  if (!(bounds_.min == other.bounds_.min) || !(bounds_.max == other.bounds_.max)) return false;
  if (rows_ == other.rows_) return true;
  if (count() != other.count()) return false;
  for (int y = bounds_.min.y; y < bounds_.max.y; ++y) {
    std::vector<Span> mine;
    for_each_span(y, [&](const Span& span) { mine.push_back(span); });
    std::size_t at = 0;
    bool is_same = true;
    other.for_each_span(y, [&](const Span& span) {
      is_same = is_same && at < mine.size() && mine[at] == span;
      ++at;
    });
    if (!is_same || at != mine.size()) return false;
  }
  return true;
}

}  // namespace roomatlas
