// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <cstdio>
#include "roomatlas/correct/place.hpp"

namespace roomatlas::bench {
namespace {

using Json = nlohmann::json;
using Cells = std::vector<std::string>;

/// What stands at a path such as "/relations/before", or null.
const Json& at(const Json& json, const std::string& path) {
  static const Json kNothing;
  const Json::json_pointer pointer(path);
  return json.contains(pointer) ? json.at(pointer) : kNothing;
}

/// A number with so many decimals; nothing where there is none.
std::string number(const Json& value, int decimals) {
  if (!value.is_number()) return "";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value.get<double>());
  return text;
}

std::string percent(const Json& share) {
  return share.is_number() ? number(100.0 * share.get<double>(), 0) + " %" : "";
}

/// "0.136 m, 3.03 deg" as "0.136, 3.03".
std::string both(const std::string& first, const std::string& second) {
  return first.empty() ? second : second.empty() ? first : first + ", " + second;
}

std::string line_of(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// A table that is left out where it has no line.
class Table {
 public:
  Table(std::string title, Cells heading)
      : title_(std::move(title)), heading_(std::move(heading)) {}
  void add(const Cells& cells) { lines_ += line_of(cells); }
  [[nodiscard]] std::string text() const {
    if (lines_.empty()) return "";
    std::string rule = "|";
    for (std::size_t i = 0; i < heading_.size(); ++i) rule += "---|";
    return title_ + "\n\n" + line_of(heading_) + rule + "\n" + lines_ + "\n";
  }

 private:
  std::string title_;
  Cells heading_;
  std::string lines_;
};

/// One line for odometry, before the first variant's, and one for the variant.
template <typename Line>
void add_before_and_after(Table& table, const Mapped& mapped, const Line& line) {
  if (mapped.is_first_variant) table.add(line("odometry", "before"));
  table.add(line(mapped.variant, "after"));
}

std::string relations_table(const std::vector<Mapped>& all) {
  Table table("**Relations**: mean translation (m), rotation (deg)",
              {"log", "map", "covered", "all", "local", "loop", "maximum"});
  for (const Mapped& mapped : all) {
    const Json& relations = at(mapped.summary, "/evaluation/relations");
    if (relations.is_null()) continue;
    const auto line = [&](const std::string& name, const std::string& side) -> Cells {
      const Json& errors = relations[side];
      const auto pair = [&](const char* subset, const char* statistic) {
        return both(number(errors[subset]["translation_m"][statistic], 3),
                    number(errors[subset]["rotation_deg"][statistic], 2));
      };
      return {mapped.mission,
              name,
              number(errors["matched"], 0) + " of " + number(errors["relations"], 0) + " (" +
                  percent(errors["coverage"]) + ")",
              pair("all", "mean"),
              pair("local", "mean"),
              pair("loop", "mean"),
              pair("all", "max")};
    };
    add_before_and_after(table, mapped, line);
  }
  return table.text();
}

std::string poses_table(const std::vector<Mapped>& all) {
  Table table(
      "**True poses**, aligned at the first; rooms: mean rotation, translation, aligned as a whole",
      {"mission", "map", "covered", "position, mean (m)", "maximum", "heading, mean (deg)",
       "maximum", "rooms (deg, m)"});
  for (const Mapped& mapped : all) {
    const Json& evaluation = at(mapped.summary, "/evaluation");
    if (at(evaluation, "/true_poses").is_null()) continue;
    const auto line = [&](const std::string& name, const std::string& side) -> Cells {
      const Json& errors = evaluation["true_poses"][side];
      const Json& rooms = at(evaluation, "/room_poses/" + side);
      return {mapped.mission,
              name,
              number(errors["matched"], 0) + " of " + number(errors["poses"], 0),
              number(errors["position_m"]["mean"], 3),
              number(errors["position_m"]["max"], 3),
              number(errors["heading_deg"]["mean"], 2),
              number(errors["heading_deg"]["max"], 2),
              both(number(at(rooms, "/mean_rotation_deg"), 2),
                   number(at(rooms, "/mean_translation_m"), 2))};
    };
    add_before_and_after(table, mapped, line);
  }
  return table.text();
}

/// "no, 3" for a graph that three edits make the true one.
std::string graph_of(const Json& graph) {
  if (graph.is_null()) return "";
  const int edits =
      graph["missing"].get<int>() + graph["extra"].get<int>() + graph["wrong"].get<int>();
  return (graph["isomorphic"].get<bool>() ? "yes, " : "no, ") + std::to_string(edits);
}

std::string used_doors_of(const Json& plan) {
  const std::size_t used = plan["used_true_doors"].size();
  if (used == 0) return "";
  return std::to_string(used - plan["missed_used_doors"].size()) + " of " + std::to_string(used);
}

std::string plans_table(const std::vector<Mapped>& all) {
  Table table("**Plan** against the true plan",
              {"mission", "map", "rooms, true", "F1 at IoU 0.5, 0.75", "mean IoU", "doors F1",
               "used doors found", "isomorphic, edits", "walls: median, 95 % (m)", "area error"});
  for (const Mapped& mapped : all) {
    const Json& plan = at(mapped.summary, "/evaluation/plan");
    if (plan.is_null()) continue;
    const Json& walls = at(mapped.summary, "/evaluation/walls");
    table.add({mapped.mission, mapped.variant,
               both(number(plan["rooms"], 0), number(plan["true_rooms"], 0)),
               both(number(plan["f1"], 2), number(plan["strict"]["f1"], 2)),
               number(plan["mean_iou"], 2), number(at(plan, "/doors/f1"), 2), used_doors_of(plan),
               graph_of(at(plan, "/graph")),
               both(number(at(walls, "/plan_to_truth/median_m"), 3),
                    number(at(walls, "/plan_to_truth/percentile_95_m"), 3)),
               percent(at(walls, "/mean_area_error"))});
  }
  return table.text();
}

std::string self_table(const std::vector<Mapped>& all) {
  Cells heading = {"mission", "map", "ASRs", "rooms", "doors", "sum", "verdict"};
  for (const Mapped& mapped : all) {
    const Json& figures = at(mapped.summary, "/evaluation/consistency/figures");
    if (figures.is_null()) continue;
    for (const Json& figure : figures) {
      const auto unit = figure["unit"].get<std::string>();
      heading.push_back(figure["figure"].get<std::string>() +
                        (unit.empty() ? "" : " (" + unit + ")"));
    }
    break;
  }
  Table table("**Without truth**", heading);
  Cells former;
  for (const Mapped& mapped : all) {
    const Json& self = at(mapped.summary, "/evaluation/consistency");
    if (self.is_null()) continue;
    const auto line = [&](const std::string& name, const std::string& side) {
      const bool is_after = side == "after";
      Cells cells = {mapped.mission,
                     name,
                     is_after ? number(mapped.summary["room_graph"]["asrs"], 0) : "",
                     is_after ? std::to_string(mapped.summary["plan"]["rooms"].size()) : "",
                     is_after ? number(mapped.summary["plan"]["doors"], 0) : "",
                     number(self["inconsistency_" + side], 2),
                     is_after ? self["verdict"].get<std::string>() : ""};
      for (const Json& figure : self["figures"]) cells.push_back(number(figure[side], 3));
      return cells;
    };
    // Which ASRs are one room differs between variants, and what odometry scores with it.
    if (Cells odometry = line("odometry", "before"); odometry != former) {
      table.add(odometry);
      former = std::move(odometry);
    }
    table.add(line(mapped.variant, "after"));
  }
  return table.text();
}

std::string failures(const std::vector<Mapped>& all) {
  std::string text;
  for (const Mapped& mapped : all) {
    if (!mapped.summary.is_null()) continue;
    text += "- " + mapped.mission + (mapped.variant.empty() ? "" : ", " + mapped.variant) + ": " +
            mapped.run.complaint + "\n";
  }
  return text.empty() ? "" : "**Not measured**:\n\n" + text + "\n";
}

}  // namespace

std::string accuracy_tables(const std::vector<Mapped>& all) {
  return relations_table(all) + poses_table(all) + plans_table(all) + self_table(all) +
         failures(all);
}

std::string cost_table(const std::vector<Mapped>& all) {
  Table table("Time and memory of `roomatlas build`, this run",
              {"mission", "map", "elapsed (s)", "processor (s)", "memory (MB)"});
  for (const Mapped& mapped : all) {
    if (mapped.summary.is_null()) continue;
    table.add({mapped.mission, mapped.variant, number(mapped.run.elapsed_s, 1),
               number(mapped.run.processor_s, 1), number(mapped.run.peak_mb, 0)});
  }
  return table.text();
}

}  // namespace roomatlas::bench
