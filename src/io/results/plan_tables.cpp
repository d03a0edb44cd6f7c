// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_tables.hpp"

#include "table_text.hpp"

#include <algorithm>

namespace roomatlas::io {
namespace {

/// run, metric, subset, quantity, unit, covered, of, count, rmse, then `mean`.
std::string csv_line(const std::string& run, const PlanFigure& figure) {
  constexpr std::size_t kColumnsBehind = 12;  // nothing is known there
  std::string line = csv_text(run) + ',' + csv_text(figure.metric) + ",," +
                     csv_text(figure.quantity) + ',' + csv_text(figure.unit) + ',';
  if (figure.of > 0) line += std::to_string(figure.covered);
  line += ',';
  if (figure.of > 0) line += std::to_string(figure.of);
  line += ",,";
  add_csv(line, figure.value);
  return line + std::string(kColumnsBehind, ',') + "\r\n";
}

std::string latex_cell(const PlanFigure& line, const JudgedPlan& plan) {
  for (const PlanFigure& figure : plan_figures(plan.evaluation)) {
    if (!figure.is_like(line)) continue;
    std::string cell = figure.word.empty() ? short_number(figure.value) : latex_text(figure.word);
    if (figure.of > 0) {
      cell += " (" + std::to_string(figure.covered) + "/" + std::to_string(figure.of) + ")";
    }
    return cell;
  }
  return "--";
}

}  // namespace

std::string plan_csv_lines(const std::vector<JudgedPlan>& plans) {
  std::string text;
  for (const JudgedPlan& plan : plans) {
    for (const PlanFigure& figure : plan_figures(plan.evaluation)) {
      text += csv_line(plan.name, figure);
    }
  }
  return text;
}

std::string plan_latex(const std::vector<JudgedPlan>& plans) {
  if (plans.empty()) return "";
  std::string text = "\\begin{tabular}{l" + std::string(plans.size(), 'r') + "}\n\\toprule\nfigure";
  for (const JudgedPlan& plan : plans) text += " & " + latex_text(plan.name);
  text += " \\\\\n\\midrule\n";
  for (const PlanFigure& line : lines_of(plans)) {
    text += latex_text(line.metric + ": " + line.quantity +
                       (line.unit.empty() ? "" : " (" + line.unit + ")"));
    for (const JudgedPlan& plan : plans) text += " & " + latex_cell(line, plan);
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace roomatlas::io
