// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_tables.hpp"
#include "table_text.hpp"

#include "roomatlas/evaluate/figures.hpp"
#include "roomatlas/io/results/comparison_text.hpp"

#include <optional>

namespace roomatlas {
namespace {

using io::add_csv;
using io::csv_text;
using io::latex_text;
using io::short_number;

void add_csv(std::string& line, const std::optional<ConfidenceInterval>& interval, bool with_mean) {
  const ConfidenceInterval none;
  const ConfidenceInterval& shown = interval ? *interval : none;
  if (with_mean) add_csv(line, shown.mean);
  add_csv(line, shown.low);
  add_csv(line, shown.high);
}

/// The figures that have an interval, each once: the columns of the table.
std::vector<const Figure*> columns_of(const std::vector<Figure>& all) {
  std::vector<const Figure*> columns;
  for (const Figure& figure : all) {
    const auto same = [&](const Figure* other) {
      return other->metric == figure.metric && other->quantity == figure.quantity;
    };
    bool known = !figure.interval;
    for (const Figure* column : columns) known = known || same(column);
    if (!known) columns.push_back(&figure);
  }
  return columns;
}

std::string heading_of(const Figure& column) {
  std::string heading = column.metric == "relations" ? column.quantity : column.metric;
  if (column.metric != "relations") {
    for (char& c : heading) c = static_cast<char>(c - 'a' + 'A');
  }
  if (!column.unit.empty()) heading += " (" + column.unit + ")";
  return latex_text(heading);
}

std::string cell_of(const JudgedRun& run, const Figure& column, const std::vector<Figure>& all) {
  for (const Figure& figure : all) {
    if (figure.run != run.name || !figure.interval || figure.metric != column.metric ||
        figure.quantity != column.quantity) {
      continue;
    }
    return short_number(figure.statistics.mean) + " [" + short_number(figure.interval->low) + ", " +
           short_number(figure.interval->high) + "]";
  }
  return "--";
}

std::string trajectories_latex(const Comparison& comparison) {
  const std::vector<Figure> all = figures(comparison);
  const std::vector<const Figure*> columns = columns_of(all);
  std::string text =
      "% mean error [95 % interval by block bootstrap] against " + latex_text(comparison.truth) +
      "; times: " + latex_text(describe(comparison.options.match, comparison.carried)) +
      "\n\\begin{tabular}{l" + std::string(columns.size(), 'r') + "}\n\\toprule\n";
  text += "run";
  for (const Figure* column : columns) text += " & " + heading_of(*column);
  text += " \\\\\n\\midrule\n";
  for (const JudgedRun& run : comparison.runs) {
    text += latex_text(run.name);
    for (const Figure* column : columns) text += " & " + cell_of(run, *column, all);
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::string to_csv(const Comparison& comparison, const std::vector<JudgedPlan>& plans) {
  std::string text =
      "run,metric,subset,quantity,unit,covered,of,count,rmse,mean,median,std,min,max,sse,squared,"
      "mean_low,mean_high,less_first,less_first_low,less_first_high,shared\r\n";
  for (const Figure& figure : figures(comparison)) {
    std::string line = csv_text(figure.run);
    for (const std::string& field : {figure.metric, figure.subset, figure.quantity, figure.unit,
                                     std::to_string(figure.covered), std::to_string(figure.of),
                                     std::to_string(figure.statistics.count)}) {
      line += ',' + csv_text(field);
    }
    for (const auto& entry : named(figure.statistics)) add_csv(line, entry.second);
    add_csv(line, figure.statistics.mean_square);
    add_csv(line, figure.interval, false);
    add_csv(line, figure.against_first, true);
    line += figure.against_first ? "," + std::to_string(figure.shared) : ",";
    text += line + "\r\n";
  }
  return text + io::plan_csv_lines(plans);
}

std::string to_latex(const Comparison& comparison, const std::vector<JudgedPlan>& plans) {
  return (comparison.has_figures() ? trajectories_latex(comparison) : "") + io::plan_latex(plans);
}

}  // namespace roomatlas
