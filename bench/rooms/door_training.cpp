// SPDX-License-Identifier: GPL-3.0-or-later
#include "door_training.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace roomatlas::bench {
namespace {

constexpr double kMinKnownCells =
    20.0;  // a region with fewer cells of true rooms is not asked about
constexpr double kMostAreaM2 = 20.0;
constexpr int kNewtonSteps = 30;

/// Which true room each region mostly lies in, while regions are being joined.
class TrueRooms {
 public:
  explicit TrueRooms(const TrainingMap& map) : cells_(map.cells_of_room) {}
  /// 0: not known.
  [[nodiscard]] std::size_t of(std::int32_t region) const {
    const std::vector<double>& cells = cells_[static_cast<std::size_t>(region)];
    double sum = 0.0;
    std::size_t most = 1;
    for (std::size_t room = 1; room < cells.size(); ++room) {
      sum += cells[room];
      if (cells[room] > cells[most]) most = room;
    }
    return sum > kMinKnownCells ? most : 0;
  }
  void join(const RegionGraph::Pair& pair) {
    for (std::size_t room = 0; room < cells_[0].size(); ++room) {
      const double sum = cells_[static_cast<std::size_t>(pair.first)][room] +
                         cells_[static_cast<std::size_t>(pair.second)][room];
      cells_[static_cast<std::size_t>(pair.first)][room] = sum;
      cells_[static_cast<std::size_t>(pair.second)][room] = sum;
    }
  }

 private:
  std::vector<std::vector<double>> cells_;
};

}  // namespace

TrainingMap training_map(const LabelledMap& map, const CutBuilding& cut) {
  TrainingMap result{RegionGraph(cut.pieces, cut.floor.frame, cut.openings), cut.pieces, {}};
  const std::int32_t rooms =
      *std::max_element(map.true_room.values.begin(), map.true_room.values.end());
  result.cells_of_room.assign(static_cast<std::size_t>(cut.pieces.count) + 1,
                              std::vector<double>(static_cast<std::size_t>(rooms) + 1, 0.0));
  const Raster<std::int32_t>& piece_of_cell = cut.pieces.piece_of_cell;
  for_each_cell(piece_of_cell.domain, [&](const Cell& cell) {
    const auto piece = static_cast<std::size_t>(piece_of_cell[cell]);
    ++result.cells_of_room[piece][static_cast<std::size_t>(map.true_room.get(cell))];
  });
  return result;
}

std::vector<DoorSample> samples_on_the_way(const TrainingMap& map, const DoorWeights& order) {
  RegionGraph graph = map.graph;
  TrueRooms rooms(map);
  std::vector<DoorSample> samples;
  const auto note = [&](const RegionGraph::Pair& pair) {
    const std::size_t a = rooms.of(pair.first);
    const std::size_t b = rooms.of(pair.second);
    if (a == 0 || b == 0) return;
    const double smaller_m2 =
        std::min(graph.region(pair.first).area_m2, graph.region(pair.second).area_m2);
    samples.push_back({graph.figures(pair), a != b, std::sqrt(std::min(smaller_m2, kMostAreaM2))});
  };
  for (bool any = true; any;) {  // as join_corridors does, with the true rooms kept up to date
    any = false;
    for (const RegionGraph::Pair& pair : graph.pairs()) {
      if (!graph.touch(pair) || !graph.share_corridor(pair)) continue;
      rooms.join(pair);
      graph.join(pair);
      any = true;
    }
  }
  for (const RegionGraph::Pair& pair : graph.pairs()) note(pair);
  DoorQueue queue(graph, order);
  while (!queue.empty()) {
    const RegionGraph::Pair pair = queue.least().second;
    const std::size_t a = rooms.of(pair.first);
    const std::size_t b = rooms.of(pair.second);
    if (a != 0 && b != 0 && a != b) {
      queue.drop(pair);
      continue;
    }
    rooms.join(pair);
    for (const RegionGraph::Pair& asked : queue.join(graph, pair)) note(asked);
  }
  return samples;
}

DoorWeights fit_doors(const std::vector<DoorSample>& samples, double penalty) {
  using Vector = Eigen::Matrix<double, kDoorFigures + 1, 1>;
  using Matrix = Eigen::Matrix<double, kDoorFigures + 1, kDoorFigures + 1>;
  using Figures = Eigen::Matrix<double, kDoorFigures, 1>;
  const auto figures = [](const DoorSample& sample) {
    return Eigen::Map<const Figures>(sample.figures.data());
  };
  const auto count = static_cast<double>(samples.size());
  Figures mean = Figures::Zero();
  Figures square = Figures::Zero();
  double weights = 0.0;
  for (const DoorSample& sample : samples) {
    mean += figures(sample) / count;
    square += figures(sample).cwiseAbs2() / count;
    weights += sample.weight / count;
  }
  const Figures scale = (square - mean.cwiseAbs2()).cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
  Vector model = Vector::Zero();  // the bias last
  for (int step = 0; step < kNewtonSteps; ++step) {
    Matrix hessian = Matrix::Zero();
    Vector gradient = Vector::Zero();
    for (std::size_t i = 0; i < kDoorFigures; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      hessian(k, k) = penalty;
      gradient(k) = penalty * model(k);
    }
    for (const DoorSample& sample : samples) {
      Vector x;
      x << (figures(sample) - mean).cwiseProduct(scale), 1.0;
      const double weight = sample.weight / weights;
      const double p = 1.0 / (1.0 + std::exp(-model.dot(x)));
      gradient += weight * (p - (sample.is_door ? 1.0 : 0.0)) * x;
      hessian += weight * p * (1.0 - p) * x * x.transpose();
    }
    const Vector change = hessian.ldlt().solve(gradient);
    model -= change;
    if (change.norm() < 1e-9) break;
  }
  DoorWeights result;
  const Figures unscaled = model.head<kDoorFigures>().cwiseProduct(scale);
  for (std::size_t i = 0; i < kDoorFigures; ++i) {
    result.weights[i] = unscaled(static_cast<Eigen::Index>(i));
  }
  result.bias = model(kDoorFigures) - unscaled.dot(mean);
  return result;
}

DoorWeights train_doors(const std::vector<const TrainingMap*>& maps, double penalty) {
  DoorWeights order;
  order.weights[0] = 1.0;
  std::vector<DoorSample> samples;
  for (int round = 0; round < 2; ++round) {
    for (const TrainingMap* map : maps) {
      const std::vector<DoorSample> more = samples_on_the_way(*map, order);
      samples.insert(samples.end(), more.begin(), more.end());
    }
    order = fit_doors(samples, penalty);
  }
  return order;
}

}  // namespace roomatlas::bench
