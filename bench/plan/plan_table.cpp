// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_table.hpp"

#include <cmath>
#include <cstdio>

namespace roomatlas::bench {
namespace {

struct Column {
  const char* title;
  double PlanScore::*value;
  int decimals;
  double factor;
};

constexpr Column kColumns[] = {
    {"rooms", &PlanScore::rooms, 0, 1.0},
    {"true", &PlanScore::true_rooms, 0, 1.0},
    {"F1 .5", &PlanScore::rooms_f1, 2, 1.0},
    {"F1 .75", &PlanScore::strict_rooms_f1, 2, 1.0},
    {"IoU", &PlanScore::mean_true_iou, 2, 1.0},
    {"corners F1", &PlanScore::corners_f1, 2, 1.0},
    {"walls (m)", &PlanScore::walls_m, 3, 1.0},
    {"area error (%)", &PlanScore::area_error, 1, 100.0},
    {"doors F1", &PlanScore::doors_f1, 2, 1.0},
    {"door width (m)", &PlanScore::door_width_m, 3, 1.0},
    {"edits", &PlanScore::edits, 0, 1.0},
    {"vertices a room", &PlanScore::vertices_a_room, 1, 1.0},
    {"true", &PlanScore::true_vertices_a_room, 1, 1.0},
    {"assemble (s)", &PlanScore::assemble_s, 1, 1.0},
};

std::string cells_of(const PlanScore& score, int more_decimals) {
  std::string text;
  for (const Column& column : kColumns) {
    const double value = column.factor * score.*column.value;
    char number[64] = "";
    const int decimals = column.decimals == 0 ? more_decimals : column.decimals;
    if (std::isfinite(value)) std::snprintf(number, sizeof number, "%.*f", decimals, value);
    text += std::string(" ") + number + " |";
  }
  return text;
}

std::string mean_line(const std::string& group, const std::vector<const PlanRow*>& rows) {
  PlanScore mean;
  for (const Column& column : kColumns) {
    double sum = 0.0;
    int count = 0;
    for (const PlanRow* row : rows) {
      const double value = row->score.*column.value;
      if (!std::isfinite(value)) continue;
      sum += value;
      ++count;
    }
    if (count > 0) mean.*column.value = sum / count;
  }
  return "| **mean, " + group + "** |" + cells_of(mean, 1) + "\n";
}

}  // namespace

std::string plan_line(const PlanRow& row) {
  if (row.failure.empty()) return "| " + row.name + " |" + cells_of(row.score, 0) + "\n";
  return "| " + row.name + ": " + row.failure + " |" + cells_of(row.score, 0) + "\n";
}

std::string plan_table(const std::vector<PlanRow>& rows) {
  std::string text = "| case |";
  std::string rule = "|---|";
  for (const Column& column : kColumns) {
    text += std::string(" ") + column.title + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  std::string means;
  for (std::size_t begin = 0; begin < rows.size();) {
    std::vector<const PlanRow*> group;
    std::size_t end = begin;
    while (end < rows.size() && rows[end].group == rows[begin].group) {
      text += plan_line(rows[end]);
      group.push_back(&rows[end++]);
    }
    if (group.size() > 1) means += mean_line(rows[begin].group, group);
    begin = end;
  }
  return text + means;
}

}  // namespace roomatlas::bench
