// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_contacts.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace roomatlas::io {
namespace {

using Corner = std::pair<int, int>;  // y, x: lowest first
using Neighbours = std::map<Corner, std::vector<Corner>>;

constexpr std::pair<int, int> kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};  // edges, no corners

/// For each pair of labels that touch, the graph of cell corners along the contact.
std::map<std::pair<int, int>, Neighbours> contact_graphs(const CellGrid<int>& labels) {
  std::map<std::pair<int, int>, Neighbours> graphs;
  const auto add = [&](int a, int b, const Corner& from, const Corner& to) {
    if (a == b || a == 0 || b == 0) return;
    Neighbours& graph = graphs[std::minmax(a, b)];
    graph[from].push_back(to);
    graph[to].push_back(from);
  };
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      add(labels(x, y), labels.get(x + 1, y, 0), {y, x + 1}, {y + 1, x + 1});
      add(labels(x, y), labels.get(x, y + 1, 0), {y + 1, x}, {y + 1, x + 1});
    }
  }
  return graphs;
}

Point2 point_of(const Corner& corner) { return {corner.second, corner.first}; }

/// Takes the corners that hang together with `start` out of the graph.
std::vector<Point2> take_line(Neighbours& graph, const Corner& start) {
  std::vector<Point2> line;
  std::vector<Corner> open = {start};
  while (!open.empty()) {
    const auto node = graph.extract(open.back());
    open.pop_back();
    if (node.empty()) continue;
    line.push_back(point_of(node.key()));
    open.insert(open.end(), node.mapped().begin(), node.mapped().end());
  }
  return line;
}

Point2 farthest_from(const Point2& point, const std::vector<Point2>& line) {
  return *std::max_element(line.begin(), line.end(), [&](const Point2& a, const Point2& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
}

}  // namespace

CellGrid<int> spread_labels(const CellGrid<int>& labels, const CellGrid<char>& free,
                            int most_steps) {
  CellGrid<int> spread = labels;
  std::vector<Corner> front;
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      if (labels(x, y) != 0) front.emplace_back(y, x);
    }
  }
  for (int step = 0; step < most_steps && !front.empty(); ++step) {
    std::map<Corner, int> reached;
    for (const auto& [y, x] : front) {
      for (const auto& [dx, dy] : kSteps) {
        if (!free.has(x + dx, y + dy) || free(x + dx, y + dy) == 0) continue;
        if (spread(x + dx, y + dy) != 0) continue;
        const auto [entry, is_new] = reached.try_emplace({y + dy, x + dx}, spread(x, y));
        if (!is_new) entry->second = std::min(entry->second, spread(x, y));
      }
    }
    front.clear();
    for (const auto& [cell, label] : reached) {
      spread(cell.second, cell.first) = label;
      front.push_back(cell);
    }
  }
  return spread;
}

std::vector<LabelContact> label_contacts(const CellGrid<int>& labels) {
  std::vector<LabelContact> contacts;
  for (auto& [pair, graph] : contact_graphs(labels)) {
    while (!graph.empty()) {
      const std::vector<Point2> line = take_line(graph, graph.begin()->first);
      // exact for a straight or gently bent line
      const Point2 one_end = farthest_from(line.front(), line);
      contacts.push_back({pair.first, pair.second, {one_end, farthest_from(one_end, line)}});
    }
  }
  return contacts;
}

}  // namespace roomatlas::io
