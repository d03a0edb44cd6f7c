// SPDX-License-Identifier: GPL-3.0-or-later
#include <spdlog/spdlog.h>

#include <algorithm>

#include "comparison_report.hpp"
#include "console.hpp"
#include "output_places.hpp"
#include "roomatlas/draw/plots.hpp"
#include "roomatlas/evaluate/figures.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/results/comparison_text.hpp"
#include "roomatlas/io/trajectories/evo_archive.hpp"

namespace roomatlas::apps {
namespace {

/// Letters, digits, dots and dashes, for a file's name.
std::string plain(std::string name) {
  for (char& c : name) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '.' || c == '-';
    if (!fits) c = '_';
  }
  return name;
}

double first_time_of(const Comparison& comparison) {
  double first_s = std::numeric_limits<double>::infinity();
  for (const JudgedRun& run : comparison.runs) {
    if (run.relations) {
      for (const RelationError& e : run.relations->errors.errors)
        first_s = std::min(first_s, e.t2_s);
    }
    if (run.true_poses) {
      for (const double time_s : run.true_poses->matched.timestamps_s) {
        first_s = std::min(first_s, time_s);
      }
    }
  }
  return first_s;
}

struct Plotted {
  std::vector<PlotSeries> translation;
  std::vector<PlotSeries> rotation;
  std::vector<PlotSeries> ape;
  std::vector<PlotSeries> rpe;
};

void add_relations(const JudgedRun& run, double start_s, Plotted& plotted) {
  if (!run.relations) return;
  PlotSeries translation{run.name, {}, {}};
  PlotSeries rotation{run.name, {}, {}};
  for (const RelationError& error : run.relations->errors.errors) {
    translation.x.push_back(error.t2_s - start_s);
    translation.y.push_back(error.translation_m);
    rotation.x.push_back(error.t2_s - start_s);
    rotation.y.push_back(error.rotation_deg);
  }
  plotted.translation.push_back(std::move(translation));
  plotted.rotation.push_back(std::move(rotation));
}

PlotSeries series_of(const JudgedRun& run, const PoseErrors& errors, double start_s) {
  PlotSeries series{run.name, {}, errors.errors};
  for (const std::size_t place : errors.places) {
    series.x.push_back(run.true_poses->matched.timestamps_s[place] - start_s);
  }
  return series;
}

void write_pair(const Path& folder, const std::string& stem, const std::string& title,
                const std::string& axis, const std::vector<PlotSeries>& series, bool is_joined) {
  if (series.empty()) return;
  write_file(folder / (stem + "_over_time.svg"),
             plot_over({title + " over time", "time (s)", axis}, series, is_joined));
  write_file(folder / (stem + "_histogram.svg"),
             plot_histogram({title + ", how often", axis, "share (%)"}, series));
}

void write_maps(const JudgedRun& run, const CompareOptions& options, const Path& folder) {
  if (run.relations) {
    Polyline places;
    std::vector<double> values;
    for (const RelationError& error : run.relations->errors.errors) {
      places.push_back(error.map_from_pose2.position());
      values.push_back(error.translation_m);
    }
    write_file(folder / ("map_relations_" + plain(run.name) + ".svg"),
               plot_map("Translation error of relations: " + run.name, "m", places, values, {}));
  }
  if (!run.true_poses) return;
  const JudgedPoses& judged = *run.true_poses;
  Polyline places;
  Polyline truth;
  for (std::size_t i = 0; i < judged.matched.size(); ++i) {
    places.push_back(judged.ape.truth_from_estimate *
                     judged.matched.estimate_from_robot[i].position());
    truth.push_back(judged.matched.truth_from_robot[i].position());
  }
  write_file(folder / ("map_ape_" + plain(run.name) + ".svg"),
             plot_map("Absolute pose error: " + run.name, unit_of(options.ape.relation), places,
                      judged.ape.errors, truth));
}

void write_plots(const Comparison& comparison, const Path& folder) {
  make_folder(folder);
  const double start_s = first_time_of(comparison);
  Plotted plotted;
  for (const JudgedRun& run : comparison.runs) {
    add_relations(run, start_s, plotted);
    if (run.true_poses) {
      plotted.ape.push_back(series_of(run, run.true_poses->ape, start_s));
      plotted.rpe.push_back(series_of(run, run.true_poses->rpe, start_s));
    }
    write_maps(run, comparison.options, folder);
  }
  const auto axis = [](PoseRelation relation) {
    const std::string unit = unit_of(relation);
    return unit.empty() ? std::string("error") : "error (" + unit + ")";
  };
  write_pair(folder, "relations_translation", "Translation error of relations", "error (m)",
             plotted.translation, false);
  write_pair(folder, "relations_rotation", "Rotation error of relations", "error (deg)",
             plotted.rotation, false);
  write_pair(folder, "ape", "Absolute pose error", axis(comparison.options.ape.relation),
             plotted.ape, true);
  write_pair(folder, "rpe", "Relative pose error", axis(comparison.options.rpe.relation),
             plotted.rpe, true);
}

void write_archives(const Comparison& comparison, const Path& file) {
  std::vector<std::pair<std::string, EvoResult>> results;
  for (const JudgedRun& run : comparison.runs) {
    if (run.true_poses) {
      results.emplace_back(plain(run.name) + "-ape", evo_ape(run, comparison));
      if (!run.true_poses->rpe.errors.empty()) {
        results.emplace_back(plain(run.name) + "-rpe", evo_rpe(run, comparison));
      }
    }
    if (run.relations) {
      results.emplace_back(plain(run.name) + "-relations", evo_relations(run, comparison));
    }
  }
  for (const auto& [name, result] : results) {
    Path archive = file;
    if (results.size() > 1) {
      archive.replace_filename(file.stem().string() + "-" + name + file.extension().string());
    }
    write_file(archive, evo_archive(result));
    if (results.size() > 1) spdlog::info("{} is {}", name, archive.string());
  }
}

}  // namespace

void write(const Comparison& comparison, const std::vector<JudgedPlan>& plans,
           const ComparisonFiles& files) {
  if (!comparison.has_figures() && (!files.plots.empty() || !files.archive.empty())) {
    throw UsageError(
        "--plots and --archive show errors of trajectories, and there are none: give --truth FILE "
        "with relations or a trajectory");
  }
  if (!files.csv.empty()) write_file(files.csv, to_csv(comparison, plans));
  if (!files.latex.empty()) write_file(files.latex, to_latex(comparison, plans));
  if (!files.plots.empty()) write_plots(comparison, files.plots);
  if (!files.archive.empty()) write_archives(comparison, files.archive);
}

}  // namespace roomatlas::apps
