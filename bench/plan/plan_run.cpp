// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_run.hpp"

#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "accuracy/program.hpp"
#include "label_alignment.hpp"
#include "roomatlas/evaluate/plan_errors.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/label_plan.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"

namespace roomatlas::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// For a folder: letters and digits.
std::string plain(std::string name) {
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Runs the program, or throws with what it complained of.
Finished run(const Words& arguments, const fs::path& messages) {
  Finished finished = run_roomatlas(arguments, messages);
  if (finished.exit_code != 0) throw std::runtime_error(arguments[0] + ": " + finished.complaint);
  return finished;
}

/// A step whose result is kept as long as its arguments and its input stay the same.
struct KeptStep {
  Words arguments;
  fs::path input;
  fs::path output;
  fs::path record;  ///< the arguments and the input's checksum, written once the output is there

  /// @returns whether it had to run
  [[nodiscard]] bool run_unless_kept(bool again) const {
    std::string wanted;
    for (const std::string& word : arguments) wanted += word + "\n";
    wanted += sha256_of_file(input) + "\n";
    if (!again && fs::exists(output) && text_of(record) == wanted) return false;
    fs::remove(record);
    Words all = arguments;
    all.insert(all.end(), {"-q", "-o", output.string()});
    run(all, record.string() + ".messages");
    std::ofstream(record) << wanted;
    return true;
  }
};

/// The store of the mapped mission, before anything is assembled.
fs::path mapped(const PlanCase& one, const fs::path& folder, const PlanRunOptions& options) {
  fs::path log = one.source;
  bool again = options.map_again;
  if (!one.is_recorded()) {
    Words arguments = {"simulate", one.source.string()};
    arguments.insert(arguments.end(), one.simulation.begin(), one.simulation.end());
    const KeptStep simulate{arguments, one.source, folder / "mission", folder / "simulated.txt"};
    again = simulate.run_unless_kept(options.simulate_again) || again;
    log = folder / "mission" / "mission.clf";
  }
  const KeptStep map{{"map", log.string()}, log, folder / "mapped.gpkg", folder / "mapped.txt"};
  (void)map.run_unless_kept(again);
  return map.output;
}

double vertices_a_room(const FloorPlan& plan) {
  std::size_t vertices = 0;
  for (const PlanRoom& room : plan.rooms) {
    for (const Polygon& part : room.parts) {
      vertices += part.outer.size();
      for (const Ring& hole : part.holes) vertices += hole.size();
    }
  }
  return static_cast<double>(vertices) / static_cast<double>(plan.rooms.size());
}

/// What stands at a path such as "/doors/f1"; NaN where nothing does.
double number_at(const Json& json, const char* path) {
  const Json::json_pointer pointer(path);
  if (!json.contains(pointer) || !json.at(pointer).is_number()) return PlanScore::kNone;
  return json.at(pointer).get<double>();
}

PlanScore score_of(const Json& judged) {
  PlanScore score;
  score.rooms = number_at(judged, "/plan/rooms");
  score.true_rooms = number_at(judged, "/plan/true_rooms");
  score.rooms_f1 = number_at(judged, "/plan/f1");
  score.strict_rooms_f1 = number_at(judged, "/plan/strict/f1");
  score.mean_true_iou = number_at(judged, "/plan/mean_true_iou");
  score.walls_m = number_at(judged, "/walls/plan_to_truth/median_m");
  score.area_error = number_at(judged, "/walls/mean_area_error");
  if (number_at(judged, "/walls/true_corners") > 0.0) {
    score.corners_f1 = number_at(judged, "/walls/corner_score/f1");
  }
  if (number_at(judged, "/plan/graph/true_edges") > 0.0) {
    score.doors_f1 = number_at(judged, "/plan/doors/f1");
    score.door_width_m = number_at(judged, "/plan/mean_door_width_error_m");
    score.edits = number_at(judged, "/plan/graph/missing") +
                  number_at(judged, "/plan/graph/extra") + number_at(judged, "/plan/graph/wrong");
  }
  return score;
}

/// Against the world that the mission was simulated in.
PlanScore judged_by_world(const fs::path& store, const fs::path& truth, const fs::path& folder) {
  const fs::path json = folder / "evaluation.json";
  run({"evaluate", store.string(), "--truth", truth.string(), "--json", "-q",
       "--bootstrap-resamples", "1"},
      json);
  PlanScore score = score_of(Json::parse(text_of(json)).at("plans").at(0));
  score.true_vertices_a_room = vertices_a_room(read_plan(truth));
  return score;
}

/// Against labelled rooms that are laid where the readings show their borders.
PlanScore judged_by_labels(const fs::path& store_file, const fs::path& labels) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const FloorPlan in_pixels = read_label_plan(labels, 1.0);
  const LabelAlignment alignment = fit_labels(in_pixels, store, store.correction());
  std::fprintf(stderr,
               "labels: a pixel %.5f m x %.5f m, middle at %.3f, %.3f m, turned by %.4f rad%s; "
               "borders %.3f m from hits\n",
               alignment.pixel_x_m, alignment.pixel_y_m, alignment.x_m, alignment.y_m,
               alignment.angle_rad, alignment.is_half_turned ? " and half a turn" : "",
               alignment.mean_distance_m);
  const PlanErrors errors =
      plan_errors(store.plan(), laid(alignment, in_pixels), Pose2{}, {}, {.doors_known = false});
  PlanScore score;
  score.rooms = static_cast<double>(errors.rooms);
  score.true_rooms = static_cast<double>(errors.true_rooms);
  score.rooms_f1 = errors.f1;
  score.strict_rooms_f1 = errors.strict.f1;
  score.mean_true_iou = errors.mean_true_iou;
  return score;
}

PlanScore judged(const PlanCase& one, const fs::path& folder, const PlanRunOptions& options) {
  const fs::path store = folder / "building.gpkg";
  fs::copy_file(mapped(one, folder, options), store, fs::copy_options::overwrite_existing);
  Words assemble = {"assemble", store.string(), "-q"};
  assemble.insert(assemble.end(), options.assemble.begin(), options.assemble.end());
  const Finished drawn = run(assemble, folder / "assembled.messages");
  if (options.with_pictures) {
    run({"export", store.string(), "-q", "-f", "svg", "-o", (folder / "pictures").string()},
        folder / "exported.messages");
  }
  PlanScore score = one.is_recorded()
                        ? judged_by_labels(store, one.labels)
                        : judged_by_world(store, folder / "mission" / "truth.geojson", folder);
  score.vertices_a_room =
      vertices_a_room(GeoPackageStore(store, GeoPackageStore::Mode::read).plan());
  score.assemble_s = drawn.processor_s;
  return score;
}

}  // namespace

PlanRow run_plan_case(const PlanCase& one, const fs::path& out, const PlanRunOptions& options) {
  PlanRow row{one.group, one.name, {}, ""};
  const fs::path folder = out / plain(one.name);
  try {
    fs::create_directories(folder);
    if (!fs::exists(one.source)) throw std::runtime_error(one.source.string() + " is not there");
    row.score = judged(one, folder, options);
  } catch (const std::exception& error) {
    row.failure = error.what();
    row.score.rooms = row.score.rooms_f1 = row.score.strict_rooms_f1 = 0.0;
    row.score.mean_true_iou = 0.0;
  }
  return row;
}

}  // namespace roomatlas::bench
