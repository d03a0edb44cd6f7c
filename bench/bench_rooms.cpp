// SPDX-License-Identifier: GPL-3.0-or-later
// How well the rooms of labelled maps are found, and what the probability of a door is learned
// from. Rooms are paired one to one with the true ones; F1 at IoU .5 and .75, mean IoU over true
// rooms; processor seconds. The 13 maps of the folder `rooms` of the recorded data.
//   bench_rooms [MAP...]        the program as it is (it was trained on these very maps)
//   bench_rooms drafted [MAP...]  the rooms of the plans that are drafted from the maps
//   bench_rooms train           each map by weights learned from the others; turned, at half
//                               resolution; and the weights learned from all
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "recorded_data.hpp"
#include "roomatlas/draft/draft_building.hpp"
#include "roomatlas/draft/map_evidence.hpp"
#include "rooms/door_training.hpp"
#include "rooms/labelled_map.hpp"
#include "rooms/room_score.hpp"

namespace {

using namespace roomatlas;
using namespace roomatlas::bench;

constexpr double kPenalty = 10.0;                // on squared weights; larger trusts the maps less
constexpr double kTrainedTurnRad = radians(30);  // no angle that is tested

struct Row {
  std::string name;
  RoomScore score;
  double seconds = 0.0;
};

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void print_table(const std::string& title, const std::vector<Row>& rows, bool each) {
  std::printf("\n%s\n| map | true | found | F1 .5 | F1 .75 | mean IoU | s |\n", title.c_str());
  std::printf("|---|---|---|---|---|---|---|\n");
  RoomScore mean;
  std::vector<double> seconds;
  const auto count = static_cast<double>(rows.size());
  for (const Row& row : rows) {
    if (each) {
      std::printf("| %s | %d | %d | %.3f | %.3f | %.3f | %.2f |\n", row.name.c_str(),
                  row.score.true_rooms, row.score.found_rooms, row.score.f1_half,
                  row.score.f1_three_quarters, row.score.mean_iou, row.seconds);
    }
    mean.f1_half += row.score.f1_half / count;
    mean.f1_three_quarters += row.score.f1_three_quarters / count;
    mean.mean_iou += row.score.mean_iou / count;
    mean.true_rooms += row.score.true_rooms;
    mean.found_rooms += row.score.found_rooms;
    seconds.push_back(row.seconds);
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf("| **mean; median s** | %d | %d | **%.3f** | %.3f | **%.3f** | %.2f |\n",
              mean.true_rooms, mean.found_rooms, mean.f1_half, mean.f1_three_quarters,
              mean.mean_iou, seconds[seconds.size() / 2]);
}

MapCells map_cells(const LabelledMap& map) {
  MapCells cells{map.evidence.frame, Raster<MapCell>(map.true_room.domain), {}};
  for_each_cell(cells.cells.domain, [&](const Cell& cell) {
    if (map.evidence.free.at(cell)) cells.cells[cell] = MapCell::free;
    if (map.evidence.obstacle.at(cell)) cells.cells[cell] = MapCell::occupied;
  });
  return cells;
}

/// Each cell's drafted room.
Raster<std::int32_t> room_of_cell(const std::vector<DraftedRoom>& rooms, const CellFrame& frame,
                                  const CellDomain& domain) {
  Raster<std::int32_t> room_of(domain, 0);
  for (const DraftedRoom& room : rooms) {
    const Box2 reach = bounds(room.outline.outer);
    const Cell low = frame.cell_of(reach.min);
    const Cell high = frame.cell_of(reach.max);
    for_each_cell({low, {high.x + 1, high.y + 1}}, [&](const Cell& cell) {
      if (!domain.contains(cell) || !contains(room.outline, frame.center_of(cell))) return;
      room_of[cell] = static_cast<std::int32_t>(room.id);
    });
  }
  return room_of;
}

void evaluate_drafts(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (const bool furnished : {false, true}) {
    std::vector<Row> rows;
    for (const std::string& name : names) {
      const LabelledMap map = read_labelled_map(folder, name, furnished);
      const MapCells cells = map_cells(map);
      const double begin = cpu_s();
      const DraftedBuilding drafted = draft_building(evidence_of_map(cells), {});
      const double seconds = cpu_s() - begin;
      const Raster<std::int32_t> found =
          room_of_cell(drafted.rooms, map.evidence.frame, map.true_room.domain);
      rows.push_back({name, room_score(found, map.true_room, map.evidence.frame.cell_m), seconds});
    }
    print_table(furnished ? "drafted, furnished" : "drafted, clean", rows, true);
  }
}

void evaluate_program(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (const bool furnished : {false, true}) {
    std::vector<Row> rows;
    for (const std::string& name : names) {
      const LabelledMap map = read_labelled_map(folder, name, furnished);
      const double begin = cpu_s();
      const RoomPartition rooms = partition_rooms(map.evidence);
      const double seconds = cpu_s() - begin;
      rows.push_back({name,
                      room_score(rooms.room_of_cell, map.true_room, map.evidence.frame.cell_m),
                      seconds});
    }
    print_table(furnished ? "furnished" : "clean", rows, true);
  }
}

/// The rooms of a map by given weights.
RoomScore score_with(const LabelledMap& map, const DoorWeights& weights) {
  const PartitionOptions options;
  const CutBuilding cut = cut_building(map.evidence, options);
  RegionGraph graph(cut.pieces, cut.floor.frame, cut.openings);
  const JoinOptions join = join_options(options, false);
  join_to_rooms(graph, weights, join);
  Raster<std::int32_t> found(map.true_room.domain, 0);
  for_each_cell(cut.pieces.piece_of_cell.domain, [&](const Cell& cell) {
    const std::int32_t region = graph.region_of(cut.pieces.piece_of_cell[cell]);
    if (region == 0 || !found.domain.contains(cell)) return;
    if (graph.region(region).area_m2 >= join.min_room_m2) found[cell] = region;
  });
  return room_score(found, map.true_room, map.evidence.frame.cell_m);
}

void print_weights(const DoorWeights& weights) {
  std::printf("\nlearned from all maps: bias %.3f, weights", weights.bias);
  for (const double weight : weights.weights) std::printf(" %.3f,", weight);
  std::printf("\n");
}

struct KnownMap {
  std::string name;
  TrainingMap map;
};

/// Each map as it is, turned, and with cells twice as large; clean and furnished.
std::vector<KnownMap> known_maps(const std::filesystem::path& folder,
                                 const std::vector<std::string>& names) {
  std::vector<KnownMap> known;
  for (const std::string& name : names) {
    for (const bool furnished : {false, true}) {
      const LabelledMap map = read_labelled_map(folder, name, furnished);
      for (const LabelledMap& one : {map, turned(map, kTrainedTurnRad), halved(map)}) {
        known.push_back({name, training_map(one, cut_building(one.evidence, {}))});
      }
    }
  }
  return known;
}

/// @param name of a map to leave out; empty: none
DoorWeights learned_without(const std::string& name, const std::vector<KnownMap>& known) {
  std::vector<const TrainingMap*> others;
  for (const KnownMap& one : known) {
    if (one.name != name) others.push_back(&one.map);
  }
  return train_doors(others, kPenalty);
}

/// A way to alter a map, to see what does not depend on it.
struct Change {
  const char* title;
  std::function<LabelledMap(const LabelledMap&)> apply;
};

void train(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  const std::vector<KnownMap> known = known_maps(folder, names);
  std::vector<DoorWeights> weights;
  for (const std::string& name : names) weights.push_back(learned_without(name, known));
  const std::vector<Change> changes = {
      {"as it is", [](const LabelledMap& map) { return map; }},
      {"turned by 17 degrees", [](const LabelledMap& map) { return turned(map, radians(17)); }},
      {"turned by 45 degrees", [](const LabelledMap& map) { return turned(map, radians(45)); }},
      {"half resolution", halved}};
  for (const Change& change : changes) {
    for (const bool furnished : {false, true}) {
      std::vector<Row> rows;
      for (std::size_t i = 0; i < names.size(); ++i) {
        const LabelledMap map = change.apply(read_labelled_map(folder, names[i], furnished));
        const double begin = cpu_s();
        const RoomScore score = score_with(map, weights[i]);
        rows.push_back({names[i], score, cpu_s() - begin});
      }
      print_table(std::string("leaving one map out, ") + change.title +
                      (furnished ? ", furnished" : ", clean"),
                  rows, true);
    }
  }
  print_weights(learned_without("", known));
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::filesystem::path folder = recorded_data() / "rooms";
    const std::span<const char* const> parts(arguments + 1, arguments + count);
    const bool is_training = !parts.empty() && parts[0] == std::string("train");
    std::vector<std::string> names = labelled_map_names(folder);
    if (is_training) {
      train(folder, names);
      return 0;
    }
    const bool is_drafting = !parts.empty() && parts[0] == std::string("drafted");
    const std::span<const char* const> wanted = is_drafting ? parts.subspan(1) : parts;
    std::erase_if(names, [&](const std::string& name) { return !is_wanted(name, wanted); });
    if (is_drafting) {
      evaluate_drafts(folder, names);
    } else {
      evaluate_program(folder, names);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_rooms: %s\n", error.what());
    return 1;
  }
}
