// SPDX-License-Identifier: GPL-3.0-or-later
#include "building_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluation_report.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/evaluate/plan_accuracy.hpp"
#include "roomatlas/io/results/summary.hpp"
#include "roomatlas/merge/carry_over.hpp"

namespace roomatlas::apps {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr std::size_t kMostRooms = 40;  // in the list; `rooms.csv` and --json have all

/// Columns of a text as a terminal shows it: the points of code of UTF-8.
std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t columns) {
  return text + std::string(columns - std::min(columns, columns_of(text)), ' ');
}

void print_rooms(const FloorPlan& plan) {
  double area_m2 = 0.0;
  std::size_t width = 0;  // of names that are more than the room's number
  for (const PlanRoom& room : plan.rooms) {
    area_m2 += room.area_m2;
    if (is_named(room)) width = std::max(width, 2 + columns_of(room.name));
  }
  say("{}, {:.1f} m2\n", counted(plan.rooms.size(), "room"), area_m2);
  for (std::size_t i = 0; i < std::min(kMostRooms, plan.rooms.size()); ++i) {
    const PlanRoom& room = plan.rooms[i];
    const std::string name = is_named(room) ? "  " + room.name : "";
    say("  {:>4}{}  {:<8}  {:>8.1f} m2\n", room.id, padded(name, width), to_string(room.kind),
        room.area_m2);
  }
  if (plan.rooms.size() > kMostRooms) {
    say("  ... and {} more: rooms.csv has all\n", plan.rooms.size() - kMostRooms);
  }
}

void print_doors(const FloorPlan& plan) {
  const auto leading_on =
      std::count_if(plan.doors.begin(), plan.doors.end(), [](const PlanDoor& door) {
        return door.kind != DoorKind::window && !(door.room_a && door.room_b);
      });
  std::string text = openings_text(plan);
  if (leading_on > 0) text += fmt::format("; {} to where the robot was not", leading_on);
  say("{}\n", text);
}

/// How well it is measured, by itself and by truth where there is some.
void print_accuracy(const FloorPlan& plan, const std::optional<Judgement>& judgement,
                    const Evaluation& evaluation) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  const PlanAccuracy accuracy = plan_accuracy(plan, judgement);
  if (accuracy.within_room_m)
    add(fmt::format("walls of a room {:.3f} m (one sigma)", *accuracy.within_room_m));
  if (judgement) {
    add(
        fmt::format("9 of 10 rooms within {:.2f} m, lengths within {:.1f} %, headings within "
                    "{:.1f} deg",
                    judgement->place_m, 100.0 * judgement->scale_share, judgement->heading_deg));
  }
  if (!text.empty()) say("accuracy: {}\n", text);
  if (!evaluation.true_poses) return;
  const TruePosesBeforeAfter& poses = *evaluation.true_poses;
  if (poses.after.position_m.count == 0) return;
  say("against true poses: {:.3f} m off on average, odometry alone {:.3f} m\n",
      poses.after.fitted_position_m.mean, poses.before.fitted_position_m.mean);
}

/// The one sentence.
std::string trust_in(const FloorPlan& plan, const std::optional<Judgement>& judgement) {
  if (plan.rooms.empty()) return "There is no room to be trusted.";
  if (!judgement) {
    return "Nothing says how far this plan can be trusted: no readings stand behind it.";
  }
  const double percent = std::min(99.0, 100.0 * judgement->probability);
  if (judgement->probability >= kTrusted) {
    return fmt::format("This map can be trusted: it is right with a probability of {:.0f} %.",
                       percent);
  }
  const std::string why = judgement->doubts.empty() ? "" : ": " + judgement->doubts.front().text;
  return fmt::format("Check this map before you trust it: it is right with {:.0f} % alone{}.",
                     percent, why);
}

bool has(const Names& files, const char* name) {
  return std::find(files.begin(), files.end(), name) != files.end();
}

void print_files(const MadeOf& made) {
  if (has(made.files, "report.html")) {
    say("open first: {} (in a browser)\n", (made.folder / "report.html").string());
  }
  if (has(made.files, "plan.pdf")) {
    say("to print:   {}\n", (made.folder / "plan.pdf").string());
  }
  say("{} in {}\n", counted(made.files.size(), "file"), made.folder.string());
}

Json json_of(const PlanDoor& door) {
  const auto id_of = [](const std::optional<RoomId>& room) {
    return room ? Json(*room) : Json(nullptr);
  };
  return {{"id", door.id},
          {"kind", to_string(door.kind)},
          {"width_m", door.width_m},
          {"rooms", {id_of(door.room_a), id_of(door.room_b)}}};
}

Json json_of(const GoneOn& gone_on) {
  return {{"mission", gone_on.mission},
          {"after_room", gone_on.after_room},
          {"reading", gone_on.reading}};
}

void print_json(const Json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Json texts_of(const Issues& issues) {
  Json texts = Json::array();
  for (const Issue& issue : issues) texts.push_back(to_string(issue));
  return texts;
}

void print_json(const GeoPackageStore& store, const FloorPlan& plan,
                const std::optional<Judgement>& judgement, const MadeOf& made) {
  Json json = Json::parse(to_json(made.evaluation, judgement, store.metadata()["answers_json"]));
  json["rooms"] = Json::array();
  for (const PlanRoom& room : plan.rooms) {
    json["rooms"].push_back({{"id", room.id},
                             {"name", room.name},
                             {"kind", to_string(room.kind)},
                             {"area_m2", room.area_m2}});
  }
  json["doors"] = Json::array();
  for (const PlanDoor& door : plan.doors) json["doors"].push_back(json_of(door));
  json["plan_issues"] = texts_of(plan.issues);
  // What was read, with its warnings; none in a store of several missions.
  const Json mission = Json::parse(store.metadata()["mission_json"], nullptr, false);
  if (mission.is_object()) json["mission"] = mission;
  const Json seen_last = Json::parse(store.metadata()["seen_last_json"], nullptr, false);
  if (seen_last.is_object()) json["seen_last"] = seen_last;
  json["trust"] = trust_in(plan, judgement);
  json["files"] = made.files;
  json["gone_on"] = Json::array();
  for (const GoneOn& gone_on : made.gone_on) json["gone_on"].push_back(json_of(gone_on));
  print_json(json);
}

}  // namespace

void report_building(const Settings& settings, const GeoPackageStore& store, const MadeOf& made) {
  const FloorPlan plan = store.plan();
  const std::optional<Judgement> judgement = store.judgement();
  if (settings.json) return print_json(store, plan, judgement, made);
  if (settings.verbose) {
    print(made.evaluation);
  } else if (made.truth_was_given) {
    Evaluation shown = made.evaluation;
    shown.consistency.reset();  // needs no truth: `evaluate` and the report have it
    print(shown);
  }
  print_rooms(plan);
  print_doors(plan);
  print_accuracy(plan, judgement, made.evaluation);
  say("{}\n", trust_in(plan, judgement));
  print_files(made);
}

void tell_assembled(const Settings& settings, const std::filesystem::path& store_file) {
  const Evaluation evaluation = evaluation_of(settings, store_file, {}, {});
  const GeoPackageStore store(store_file, GeoPackageStore::Mode::read);
  print_json(store, store.plan(), store.judgement(), {evaluation, false, {}, {}, {}});
}

void tell_joined(const std::vector<WrittenBuilding>& written) {
  Json json = {{"buildings", Json::array()}, {"alone", Json::array()}};
  for (const WrittenBuilding& one : written) {
    Json missions = Json::array();
    for (const MemberMission& member : one.building.members) missions.push_back(member.name);
    json[missions.size() > 1 ? "buildings" : "alone"].push_back(
        {{"store", one.store.string()}, {"rooms", one.rooms}, {"missions", missions}});
  }
  print_json(json);
}

void tell_renamed(const std::filesystem::path& store, const PlanRoom& was,
                  const std::string& name) {
  print_json(Json{{"store", store.string()}, {"room", was.id}, {"was", was.name}, {"name", name}});
}

void tell_mapped(const Mapped& mapped, const std::filesystem::path& store) {
  print_json(Json{{"store", store.string()},
                  {"gone_on", mapped.gone_on ? json_of(*mapped.gone_on) : Json(nullptr)}});
}

void tell_files(const Settings& settings, const std::filesystem::path& folder, const Names& files) {
  if (settings.json) {
    print_json(Json{{"files", files}});
    return;
  }
  say("{} in {}:\n", counted(files.size(), "file"), folder.string());
  for (const std::string& file : files) say("  {}\n", file);
}

}  // namespace roomatlas::apps
