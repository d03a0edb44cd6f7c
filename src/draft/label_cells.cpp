// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_cells.hpp"

#include <algorithm>
// g++ 12 takes the end of an empty list of edges for uninitialised (boost/optional).
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <cstdint>

namespace roomatlas {
namespace {

constexpr double kUnits = 1e5;  // of flow in a unit of cost: whole numbers end for certain
constexpr double kGain = 1e-6;  // of cost; less is rounding

double border_cost(const LabelBorder& border, int first, int second) {
  if (first == second) return 0.0;
  if (first == 0 || second == 0) return border.solid_cost;
  return std::min(border.room_cost, 2.0 * border.solid_cost);
}

/// The flow network of one move: the source side keeps its labels, the sink side takes the new one.
class Network {
 public:
  explicit Network(std::size_t cells) : graph_(cells + 2), source_(cells), sink_(cells + 1) {}

  void add_to_keep(std::size_t cell, double cost) { add_arc(cell, sink_, cost, 0.0); }
  void add_to_take(std::size_t cell, double cost) { add_arc(source_, cell, cost, 0.0); }
  /// Where `first` keeps and `second` takes.
  void add_pair(std::size_t first, std::size_t second, double cost) {
    add_arc(first, second, cost, 0.0);
  }

  /// Of each cell, whether it takes the new label.
  std::vector<bool> cut() {
    const auto count = boost::num_vertices(graph_);
    std::vector<std::int64_t> residual(capacity_.size());
    std::vector<Edge> predecessor(count);
    std::vector<int> color(count);
    std::vector<std::int64_t> distance(count);
    const auto index = boost::get(boost::vertex_index, graph_);
    const auto edge_index = boost::get(boost::edge_index, graph_);
    boost::boykov_kolmogorov_max_flow(
        graph_, boost::make_iterator_property_map(capacity_.begin(), edge_index),
        boost::make_iterator_property_map(residual.begin(), edge_index),
        boost::make_iterator_property_map(reverse_.begin(), edge_index),
        boost::make_iterator_property_map(predecessor.begin(), index),
        boost::make_iterator_property_map(color.begin(), index),
        boost::make_iterator_property_map(distance.begin(), index), index, source_, sink_);
    const int of_source = color[source_];
    std::vector<bool> takes;
    for (std::size_t cell = 0; cell + 2 < count; ++cell) takes.push_back(color[cell] != of_source);
    return takes;
  }

 private:
  using Graph =
      boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                            boost::property<boost::edge_index_t, std::size_t>>;
  using Edge = boost::graph_traits<Graph>::edge_descriptor;

  void add_arc(std::size_t from, std::size_t to, double forth, double back) {
    const auto units = [](double cost) { return std::llround(cost * kUnits); };
    if (units(forth) <= 0 && units(back) <= 0) return;
    const Edge one = boost::add_edge(from, to, capacity_.size(), graph_).first;
    capacity_.push_back(units(forth));
    const Edge other = boost::add_edge(to, from, capacity_.size(), graph_).first;
    capacity_.push_back(units(back));
    reverse_.push_back(other);
    reverse_.push_back(one);
  }

  Graph graph_;
  std::size_t source_;
  std::size_t sink_;
  std::vector<std::int64_t> capacity_;
  std::vector<Edge> reverse_;
};

/// The best move towards one label: each cell keeps its own or takes it.
class Expansion {
 public:
  Expansion(const std::vector<LabelCosts>& cells, const std::vector<LabelBorder>& borders)
      : cells_(cells), borders_(borders) {}

  [[nodiscard]] std::vector<int> moved(int to, const std::vector<int>& label_of) const {
    const std::vector<std::size_t> movable = cells_near(to, label_of);
    Move move{to, label_of, std::vector<std::size_t>(cells_.size(), kFixed), {}, {}};
    for (std::size_t i = 0; i < movable.size(); ++i) {
      const LabelCosts& cell = cells_[movable[i]];
      move.place[movable[i]] = i;
      move.keep.push_back(cell.of(label_of[movable[i]]));
      move.take.push_back(cell.of(to));
    }
    Network network(movable.size());
    for (const LabelBorder& border : borders_) add(border, move, network);
    for (std::size_t i = 0; i < movable.size(); ++i) {
      const double both = std::min(move.keep[i], move.take[i]);
      network.add_to_keep(i, move.keep[i] - both);
      network.add_to_take(i, move.take[i] - both);
    }
    std::vector<int> labels = label_of;
    const std::vector<bool> takes = network.cut();
    for (std::size_t i = 0; i < movable.size(); ++i) {
      if (takes[i]) labels[movable[i]] = to;
    }
    return labels;
  }

 private:
  static constexpr std::size_t kFixed = static_cast<std::size_t>(-1);

  struct Move {
    int to;
    const std::vector<int>& label_of;
    std::vector<std::size_t> place;  ///< of each cell among those that may take the label
    std::vector<double> keep;        ///< of each of those, what its own label costs
    std::vector<double> take;        ///< and what the new one does
  };

  /// Cells that may want the label: those that have a cost of their own for it, and those around,
  /// two borders away at most. Solid any may want.
  [[nodiscard]] std::vector<std::size_t> cells_near(int to,
                                                    const std::vector<int>& label_of) const {
    constexpr int kReach = 6;  // borders; a room's own unseen corners are a few cells away
    std::vector<bool> is_near(cells_.size(), to == 0);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (label_of[i] == to || cells_[i].rooms.contains(to)) is_near[i] = true;
    }
    for (int step = 0; to != 0 && step < kReach; ++step) {
      std::vector<bool> grown = is_near;
      for (const LabelBorder& border : borders_) {
        const auto a = static_cast<std::size_t>(border.first);
        const auto b = static_cast<std::size_t>(border.second);
        if (is_near[a]) grown[b] = true;
        if (is_near[b]) grown[a] = true;
      }
      is_near.swap(grown);
    }
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (is_near[i] && label_of[i] != to) near.push_back(i);
    }
    return near;
  }

  void add(const LabelBorder& border, Move& move, Network& network) const {
    const int first = move.label_of[static_cast<std::size_t>(border.first)];
    const int second = move.label_of[static_cast<std::size_t>(border.second)];
    const double both_keep = border_cost(border, first, second);
    const double first_keeps = border_cost(border, first, move.to);
    const double second_keeps = border_cost(border, move.to, second);
    const std::size_t a = move.place[static_cast<std::size_t>(border.first)];
    const std::size_t b = move.place[static_cast<std::size_t>(border.second)];
    if (a == kFixed && b == kFixed) return;
    if (a == kFixed || b == kFixed) {
      // The fixed cell keeps its label, which may be the new one.
      const std::size_t moves = a == kFixed ? b : a;
      move.keep[moves] += both_keep;
      move.take[moves] += a == kFixed ? first_keeps : second_keeps;
      return;
    }
    // Kolmogorov and Zabih, "What energy functions can be minimized via graph cuts?", PAMI 2004.
    move.take[a] += std::max(0.0, second_keeps - both_keep);
    move.keep[a] += std::max(0.0, both_keep - second_keeps);
    move.keep[b] += second_keeps;
    network.add_pair(a, b, std::max(0.0, first_keeps + second_keeps - both_keep));
  }

  const std::vector<LabelCosts>& cells_;
  const std::vector<LabelBorder>& borders_;
};

std::vector<int> cheapest(const std::vector<LabelCosts>& cells) {
  std::vector<int> labels;
  for (const LabelCosts& cell : cells) {
    int best = 0;
    double least = cell.solid;
    for (const auto& [label, cost] : cell.rooms) {
      if (cost < least) {
        least = cost;
        best = label;
      }
    }
    labels.push_back(best);
  }
  return labels;
}

}  // namespace

double labelling_cost(const std::vector<LabelCosts>& cells, const std::vector<LabelBorder>& borders,
                      const std::vector<int>& label_of_cell) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) sum += cells[i].of(label_of_cell[i]);
  for (const LabelBorder& border : borders) {
    sum += border_cost(border, label_of_cell[static_cast<std::size_t>(border.first)],
                       label_of_cell[static_cast<std::size_t>(border.second)]);
  }
  return sum;
}

std::vector<int> label_cells(const std::vector<LabelCosts>& cells,
                             const std::vector<LabelBorder>& borders, int labels, int most_sweeps) {
  std::vector<int> best = cheapest(cells);
  double least = labelling_cost(cells, borders, best);
  const Expansion expansion(cells, borders);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool any = false;
    for (int label = 0; label < labels; ++label) {
      std::vector<int> moved = expansion.moved(label, best);
      const double cost = labelling_cost(cells, borders, moved);
      if (cost >= least - kGain) continue;
      best = std::move(moved);
      least = cost;
      any = true;
    }
    if (!any) break;
  }
  return best;
}

}  // namespace roomatlas
