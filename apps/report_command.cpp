// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "commands.hpp"
#include "evaluation_report.hpp"
#include "output_places.hpp"
#include "roomatlas/correct/place.hpp"
#include "roomatlas/draw/report.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/results/report_data.hpp"
#include "roomatlas/io/store/geopackage_store.hpp"
#include "stored_configuration.hpp"

namespace roomatlas::apps {

void write_report(const Settings& settings, const Path& store_file, const Evaluation& evaluation,
                  const Path& out) {
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  const Metadata metadata = store.metadata();
  const Correction correction = store.correction();
  const FloorPlan plan = store.plan();
  const RoomGraph graph = graph_of(store, correction);
  const CorrectOptions correct = as_corrected(settings, metadata, store_file).assemble.correct;
  const VisitUncertainty uncertainty = uncertainty_of(graph, store.closures(), correction, correct);
  const std::string data = report_data(metadata, date_of(metadata), correction, plan, graph,
                                       place(store, correction), uncertainty, evaluation);
  write_file(out, report_page(plan.title.empty() ? "Floor plan" : plan.title, data));
}

void report(const Settings& settings, const Path& store, const std::vector<Path>& truth,
            const TrajectoryFlags& flags, const Path& out) {
  std::vector<Path> inputs = truth;
  inputs.insert(inputs.end(), {store, flags.stamps_from, flags.carry});
  require_output_file(out, inputs);
  write_report(settings, store, evaluation_of(settings, store, truth, flags), out);
  spdlog::info("the report is {}: open it in a browser", out.string());
}

}  // namespace roomatlas::apps
