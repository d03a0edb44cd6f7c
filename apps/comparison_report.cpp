// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "console.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/evaluate/figures.hpp"

namespace roomatlas::apps {
namespace {

/// As many decimals as leave three or four figures that count.
std::string short_text(double value) {
  const double size = std::abs(value);
  return fmt::format("{:.{}f}", value, size >= 100.0 ? 1 : size >= 1.0 ? 3 : size >= 0.01 ? 4 : 6);
}

std::string interval_text(const ConfidenceInterval& interval) {
  return "[" + short_text(interval.low) + ", " + short_text(interval.high) + "]";
}

std::string group_of(const Figure& figure) {
  std::string heading = figure.metric == "relations"
                            ? "relations, " + figure.subset + ": " + figure.quantity
                            : (figure.metric == "ape" ? "APE, " : "RPE, ") + figure.subset;
  return figure.unit.empty() ? heading : heading + " (" + figure.unit + ")";
}

void print_row(const Figure& figure, std::size_t width) {
  const Statistics& s = figure.statistics;
  say("  {:<{}} {:>6} {:>4.0f} % {:>9} {:>22}", figure.run, width, s.count, 100.0 * figure.share(),
      short_text(s.mean), figure.interval ? interval_text(*figure.interval) : "");
  for (const double value :
       {s.rmse, s.standard_deviation, s.median, s.minimum, s.maximum, s.mean_square}) {
    say(" {:>9}", short_text(value));
  }
  say("\n");
  if (!figure.against_first) return;
  const ConfidenceInterval& less = *figure.against_first;
  const char* verdict = less.high < 0.0  ? "better"
                        : less.low > 0.0 ? "worse"
                                         : "no clear difference";
  say("  {:<{}} {:>6} {:>6} {:>9} {:>22}  than the first run: {}\n", "", width, figure.shared, "",
      (less.mean > 0.0 ? "+" : "") + short_text(less.mean), interval_text(less), verdict);
}

void print_used(const Comparison& comparison, const std::vector<std::string>& steps) {
  say("truth: {}", comparison.truth);
  if (comparison.relations > 0) say(", {}", counted(comparison.relations, "relation"));
  if (comparison.true_poses > 0) say(", {}", counted(comparison.true_poses, "pose"));
  say("\ntimes: {}\n", describe(comparison.options.match, comparison.carried));
  for (const std::string& step : steps) say("used: {}\n", step);
  for (const JudgedRun& run : comparison.runs) {
    if (run.relations) {
      say("{}: relations from {}\n", run.name, to_string(run.relations->errors.use));
    }
    if (run.true_poses) {
      say("{}: true poses with {}\n", run.name, to_string(run.true_poses->matched.use));
    }
  }
  if (comparison.true_poses > 0) {
    say("APE: {}; RPE: {}\n", to_string(comparison.options.ape.alignment),
        title_of(comparison.options.rpe).substr(title_of(comparison.options.rpe).find('\n') + 1));
  }
}

}  // namespace

void print(const Comparison& comparison, const std::vector<std::string>& steps) {
  print_used(comparison, steps);
  const std::vector<Figure> all = figures(comparison);
  std::size_t width = 3;
  for (const Figure& figure : all) width = std::max(width, figure.run.size());
  std::string heading;
  for (const Figure& figure : all) {
    if (group_of(figure) != heading) {
      heading = group_of(figure);
      say("\n{}\n  {:<{}} {:>6} {:>6} {:>9} {:>22} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", heading,
          "run", width, "count", "share", "mean", "95 % interval", "rmse", "std", "median", "min",
          "max", "squared");
    }
    print_row(figure, width);
  }
  if (all.empty()) return;
  const BootstrapOptions& bootstrap = comparison.options.bootstrap;
  say("\nintervals: circular block bootstrap of the mean, {} resamples, seed {}, blocks of "
      "the root of the count\n",
      bootstrap.resamples, bootstrap.seed);
}

}  // namespace roomatlas::apps
