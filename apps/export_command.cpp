// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "did_you_mean.hpp"
#include "output_places.hpp"
#include "plugin_formats.hpp"
#include "roomatlas/core/progress.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/evaluate/plan_accuracy.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/maps/nav2_export.hpp"
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "roomatlas/io/plans/ifc.hpp"
#include "roomatlas/io/plans/ogr_export.hpp"
#include "roomatlas/io/plans/plan_geojson.hpp"
#include "roomatlas/io/plans/rmf_building.hpp"
#include "roomatlas/io/plans/room_tables.hpp"
#include "roomatlas/io/plans/route_graph.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/io/trajectories/tum.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/merge/unexplored.hpp"
#include "stored_configuration.hpp"
#include "usable_store.hpp"
#include "write_imdf.hpp"

namespace roomatlas::apps {
namespace {

/// What the exports draw from, read once.
/// The path of a mission by odometry and corrected; a joined store has several.
struct ExportedPath {
  std::string name;  ///< goes before the files' ending: empty, or ".1", ".2" ... as in `missions`
  std::string mission;  ///< its name, of a joined store: "1 first.clf"
  Trajectory odometry;
  Trajectory corrected;
};

struct Exported {
  Metadata metadata;
  Correction correction;
  FloorPlan plan;
  PlacedMission placed;
  std::vector<ExportedPath> paths;
  RoomGraph graph;
  std::vector<Closure> closures;
  std::optional<Judgement> judgement;
  CorrectOptions correct;  ///< with which the store was assembled
  std::optional<GeoReference> on_earth;
  std::optional<double> north_deg;
  std::string ogr_driver;
  PostalAddress address;
  double storey_height_m = 0.0;
  std::string plan_svg;          ///< where some format is a drawing ...
  std::string before_after_svg;  ///< ... and, of a mission

  /// False for a plan that was drafted from a finished map.
  [[nodiscard]] bool has_mission() const { return !correction.asrs.empty(); }
};

std::vector<ExportedPath> paths_of(const GeoPackageStore& store, const Correction& correction,
                                   const PlacedMission& all) {
  const std::vector<MemberMission> members = store.members();
  if (members.empty()) return {{"", "", all.odometry, all.corrected}};
  std::vector<ExportedPath> paths;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Correction own = correction;
    std::erase_if(own.asrs, [&](const AsrCorrection& asr) {
      return asr.asr < members[i].first_asr || asr.asr > members[i].last_asr;
    });
    PlacedMission placed = place(store, own);
    paths.push_back({fmt::format(".{}", i + 1), fmt::format("{} {}", i + 1, members[i].name),
                     std::move(placed.odometry), std::move(placed.corrected)});
  }
  return paths;
}

Exported read(const Settings& settings, const Path& store_file, bool measured_walls) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  require_assembled(store);
  Exported exported{store.metadata(),
                    store.correction(),
                    measured_walls ? store.measured_plan() : store.plan(),
                    {},
                    {},
                    {},
                    store.closures(),
                    store.judgement(),
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {},
                    {}};
  exported.correct = as_corrected(settings, exported.metadata, store_file).assemble.correct;
  exported.placed = place(store, exported.correction);
  exported.paths = paths_of(store, exported.correction, exported.placed);
  exported.graph = graph_of(store, exported.correction);
  return exported;
}

PlanAnnotations annotations_of(const Exported& from) {
  PlanAnnotations annotations;
  annotations.mission = from.plan.title;
  annotations.date = date_of(from.metadata);
  annotations.path_length_m = path_length_of(from.metadata);
  for (const StampedPose& pose : from.placed.corrected) {
    annotations.trajectory.push_back(pose.pose.position());
  }
  for (const ExportedPath& path : from.paths) {
    if (path.mission.empty()) continue;
    MissionPath& mission = annotations.missions.emplace_back();
    mission.name = path.mission;
    for (const StampedPose& pose : path.corrected) mission.path.push_back(pose.pose.position());
  }
  for (const PlanDoor& door : from.plan.doors) {
    if (door.room_a && door.room_b) annotations.room_graph.emplace_back(*door.room_a, *door.room_b);
  }
  for (const AsrCorrection& asr : from.correction.asrs) {
    annotations.corrections.push_back(
        {asr.building_from_asr_before.position(), asr.building_from_asr.position()});
  }
  const VisitUncertainty uncertainty =
      uncertainty_of(from.graph, from.closures, from.correction, from.correct);
  for (const VisitEstimate& visit : uncertainty.visits) {
    annotations.uncertainty.push_back({visit.at, visit.covariance_m2});
  }
  annotations.accuracy = plan_accuracy(from.plan, from.judgement);
  if (from.judgement) {
    for (const RoomJudgement& room : from.judgement->rooms) {
      if (room.probability < kTrusted) annotations.doubtful_rooms.insert(room.room);
    }
  }
  annotations.unexplored = unexplored_boundary(from.plan, from.placed.walls_after);
  return annotations;
}

std::string plan_svg(const Exported& from, const Settings& settings) {
  DrawOptions options = settings.draw;
  options.north_deg = from.north_deg;
  return draw_plan(from.plan, annotations_of(from), options);
}

std::string before_after_svg(const Exported& from) {
  Polyline after;
  for (const StampedPose& pose : from.placed.corrected) after.push_back(pose.pose.position());
  return draw_before_after({"Odometry alone", from.placed.walls_before, from.placed.path_before},
                           {"Corrected", from.placed.walls_after, after});
}

/// The drawings, once for all formats that are drawings.
void draw(const std::vector<std::string>& formats, const Settings& settings, Exported& from) {
  const bool is_asked = std::any_of(formats.begin(), formats.end(), [](const std::string& format) {
    return format == "svg" || format == "png" || format == "pdf";
  });
  if (!is_asked) return;
  from.plan_svg = plan_svg(from, settings);
  if (from.has_mission()) from.before_after_svg = before_after_svg(from);
}

/// Corrected poses of the visits, and the measurements between them.
void write_pose_graph(const Path& file, const Exported& from) {
  const PoseGraph graph = pose_graph_of(from.graph, from.closures, from.correct);
  const Placement placement = placement_of(from.correction);
  std::vector<Pose2> poses;
  for (const AsrId id : graph.ids) poses.push_back(placement.at(id));
  write_g2o(file, graph, poses, {});
}

using Names = std::vector<std::string>;
/// Writes the files of a format. @returns their names in the folder
using Exporter = std::function<Names(const Exported&, const Settings&, const Path& out)>;

/// Of a format with one file that is a text.
Exporter text_file(const char* name, std::function<std::string(const Exported&)> text) {
  return [name, text = std::move(text)](const Exported& from, const Settings&, const Path& out) {
    write_file(out / name, text(from));
    return Names{name};
  };
}

Names write_svgs(const Exported& from, const Settings&, const Path& out) {
  write_file(out / "plan.svg", from.plan_svg);
  if (!from.has_mission()) return {"plan.svg"};
  write_file(out / "before_after.svg", from.before_after_svg);
  return {"plan.svg", "before_after.svg"};
}

Names write_pngs(const Exported& from, const Settings& settings, const Path& out) {
  write_png(out / "plan.png", from.plan_svg, settings.png_dpi);
  if (!from.has_mission()) return {"plan.png"};
  write_png(out / "before_after.png", from.before_after_svg, settings.png_dpi);
  return {"plan.png", "before_after.png"};
}

Names write_geojsons(const Exported& from, const Settings&, const Path& out) {
  write_file(out / "plan.local.geojson", to_geojson(from.plan));
  if (!from.on_earth) return {"plan.local.geojson"};
  write_file(out / "plan.geojson", to_geojson(from.plan, *from.on_earth));
  return {"plan.local.geojson", "plan.geojson"};
}

Names write_tums(const Exported& from, const Settings&, const Path& out) {
  Names names;
  for (const ExportedPath& path : from.paths) {
    names.push_back("trajectory_odometry" + path.name + ".tum");
    write_tum(out / names.back(), path.odometry);
    names.push_back("trajectory_corrected" + path.name + ".tum");
    write_tum(out / names.back(), path.corrected);
  }
  return names;
}

const std::map<std::string, Exporter>& exporters() {
  static const std::map<std::string, Exporter> table = {
      {"svg", write_svgs},
      {"png", write_pngs},
      {"pdf",
       [](const Exported& from, const Settings&, const Path& out) -> Names {
         const std::string title = from.plan.title.empty() ? "Floor plan" : from.plan.title;
         write_pdf(out / "plan.pdf", from.plan_svg, title, date_of(from.metadata));
         return {"plan.pdf"};
       }},
      {"geojson", write_geojsons},
      {"tum", write_tums},
      {"dot", text_file("rooms.dot", [](const Exported& from) { return to_dot(from.graph); })},
      {"csv", text_file("rooms.csv", [](const Exported& from) { return rooms_csv(from.plan); })},
      {"graphml",
       text_file("rooms.graphml", [](const Exported& from) { return rooms_graphml(from.plan); })},
      {"g2o",
       [](const Exported& from, const Settings&, const Path& out) -> Names {
         write_pose_graph(out / "graph.g2o", from);
         return {"graph.g2o"};
       }},
      {"nav2", [](const Exported& from, const Settings&,
                  const Path& out) { return write_nav2_map(out, from.plan); }},
      {"nav2-route", text_file("route_graph.geojson",
                               [](const Exported& from) { return nav2_route_geojson(from.plan); })},
      {"dxf",
       [](const Exported& from, const Settings&, const Path& out) -> Names {
         write_dxf(out / "plan.dxf", from.plan);
         return {"plan.dxf"};
       }},
      {"ifc", text_file("plan.ifc",
                        [](const Exported& from) {
                          return ifc_step(from.plan,
                                          {building_of(from.metadata), from.on_earth,
                                           date_of(from.metadata), from.storey_height_m});
                        })},
      {"imdf",
       [](const Exported& from, const Settings&, const Path& out) -> Names {
         write_imdf(out / "plan.imdf.zip", from.plan, from.on_earth,
                    {building_of(from.metadata), {}, from.address, date_of(from.metadata)});
         return {"plan.imdf.zip"};
       }},
      {"rmf", text_file("building.yaml",
                        [](const Exported& from) { return rmf_building_yaml(from.plan); })},
      {"ogr",
       [](const Exported& from, const Settings&, const Path& out) {
         if (from.ogr_driver.empty()) {
           throw UsageError("-f ogr needs --ogr FORMAT, such as --ogr GML");
         }
         return write_ogr(out, from.ogr_driver, from.plan);
       }},
      {"json", text_file("summary.json",
                         [](const Exported& from) {
                           return summary_json(from.metadata, from.correction, from.plan,
                                               from.graph, {});
                         })},
  };
  return table;
}

void check_formats(const std::vector<std::string>& formats) {
  for (const std::string& format : formats) {
    if (exporters().contains(format)) continue;
    throw UsageError(fmt::format("unknown format {}: expected some of {}{}", format,
                                 fmt::join(export_formats(), ","),
                                 did_you_mean(format, export_formats())));
  }
}

}  // namespace

std::vector<std::string> export_formats() {
  std::vector<std::string> names;
  for (const auto& entry : exporters()) {
    if (entry.first != "ogr") names.push_back(entry.first);
  }
  return names;
}

Names export_all(const Settings& settings, const Path& store_file, const Names& formats,
                 const ExportOptions& options, const Path& out) {
  check_formats(formats);
  Exported from = read(settings, store_file, options.measured_walls);
  from.on_earth = options.reference();
  from.north_deg = options.north_deg();
  from.ogr_driver = options.ogr_driver;
  from.address = options.postal_address();
  from.storey_height_m = options.storey_height_m;
  make_folder(out);
  const Progress progress = console_progress(settings);
  const auto is_going_on = [&](std::size_t done) {
    if (progress("draw", share_of(done, formats.size() + 1))) return;
    throw Interrupted("interrupted while drawing: the files so far are in " + out.string() +
                      "; run the same command again for all of them");
  };
  is_going_on(0);
  draw(formats, settings, from);
  Names written;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    is_going_on(i + 1);
    const Names files = exporters().at(formats[i])(from, settings, out);
    written.insert(written.end(), files.begin(), files.end());
  }
  return written;
}

void export_and_tell(const Settings& settings, const Path& store, const Names& formats,
                     const ExportOptions& options, const Path& out) {
  check_formats(formats);
  (void)options.reference();  // wrong options leave no folder behind
  make_folder(out);
  const PlaceLock lock(out);
  const bool is_asked = formats != export_formats();
  tell_files(settings, out,
             export_all(settings, store, is_asked ? formats : possible_formats(formats, store),
                        options, out));
}

}  // namespace roomatlas::apps
