// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "building_report.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "evaluation_report.hpp"
#include "output_places.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/draw/report.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/results/report_data.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "stored_configuration.hpp"
#include "truth_files.hpp"

namespace roomatlas::apps {
namespace {

/// Where the robot was in the middle of each visit.
std::map<AsrId, StampedPose> middles_of(const AsrSource& source, const Correction& correction) {
  std::map<AsrId, StampedPose> middles;
  for (const AsrCorrection& visit : correction.asrs) {
    const std::vector<PathSample> path = source.get(visit.asr, AsrDetail::path).path;
    if (path.empty()) continue;
    const PathSample& middle = path[path.size() / 2];
    middles[visit.asr] = {middle.timestamp_s, visit.building_from_asr * middle.asr_from_robot};
  }
  return middles;
}

}  // namespace

void write_report(const Settings& settings, const Path& store_file, const Evaluation& evaluation,
                  const Path& out) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  ReportSources from;
  from.metadata = store.metadata();
  from.date = date_of(from.metadata);
  from.correction = store.correction();
  from.plan = store.plan();
  from.graph = graph_of(store, from.correction);
  from.placed = place(store, from.correction);
  for (const MemberMission& member : store.members()) {
    Correction own = from.correction;
    std::erase_if(own.asrs, [&](const AsrCorrection& asr) {
      return asr.asr < member.first_asr || asr.asr > member.last_asr;
    });
    const PlacedMission placed = place(store, own);
    ReportedPath path{member.name, placed.path_before, {}};
    for (const StampedPose& pose : placed.corrected) path.after.push_back(pose.pose.position());
    from.missions.push_back(std::move(path));
  }
  const CorrectOptions correct = as_corrected(settings, from.metadata, store_file).assemble.correct;
  from.closures = store.closures();
  from.uncertainty = uncertainty_of(from.graph, from.closures, from.correction, correct);
  from.middles = middles_of(store, from.correction);
  from.evaluation = evaluation;
  const std::string title = from.plan.title.empty() ? "Floor plan" : from.plan.title;
  write_file(out, report_page(title, report_data(from)));
}

void report(const Settings& settings, const Path& store, const std::vector<Path>& truth,
            const TrajectoryFlags& flags, const Path& out) {
  std::vector<Path> inputs;
  for (const Path& one : truth) inputs.push_back(named_truth(one).file);
  inputs.insert(inputs.end(), {store, flags.stamps_from, flags.carry});
  require_output_file(out, inputs);
  const Evaluation evaluation = evaluation_of(settings, store, truth, flags);
  show(evaluation.issues);
  write_report(settings, store, evaluation, out);
  if (settings.json) tell_files(settings, out.parent_path(), {out.filename().string()});
  spdlog::info("the report is {}: open it in a browser", out.string());
}

}  // namespace roomatlas::apps
