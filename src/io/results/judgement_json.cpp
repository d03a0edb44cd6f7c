// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/results/judgement_json.hpp"

#include "roomatlas/core/issue.hpp"
#include "text/json.hpp"
#include "text/json_number.hpp"

namespace roomatlas {
namespace {

using io::finite;

Json json_of(const std::vector<JudgedFigure>& figures) {
  Json json = Json::object();
  for (const JudgedFigure& figure : figures) json[figure.name] = finite(figure.value);
  return json;
}

std::vector<JudgedFigure> figures_of(const Json& json) {
  std::vector<JudgedFigure> figures;
  for (const auto& [name, value] : json.items()) {
    figures.push_back({name, value.is_null() ? 0.0 : value.get<double>()});
  }
  return figures;
}

Json visits_of(const Judgement& judgement) {
  Json visits = Json::array();
  for (const VisitJudgement& visit : judgement.visits) {
    visits.push_back({{"asr", visit.asr},
                      {"room", visit.room},
                      {"probability", visit.probability},
                      {"place_m", visit.place_m},
                      {"figures", json_of(visit.figures)}});
  }
  return visits;
}

Json json_of(const std::vector<Advice>& all) {
  Json json = Json::array();
  for (const Advice& advice : all) {
    json.push_back({{"text", words(advice)},
                    {"kind", to_string(advice.kind)},
                    {"visits", {advice.from, advice.to}},
                    {"rooms", {advice.from_room, advice.to_room}},
                    {"by_door", advice.by_door},
                    {"drive_m", advice.drive_m},
                    {"place_m", {advice.place_before_m, advice.place_after_m}},
                    {"heading_deg", {advice.heading_before_deg, advice.heading_after_deg}}});
  }
  return json;
}

AdviceKind kind_of(const std::string& name) {
  for (const AdviceKind kind :
       {AdviceKind::cross_again, AdviceKind::drive_again, AdviceKind::use_door}) {
    if (name == to_string(kind)) return kind;
  }
  throw InputError("the judgement is damaged (advice of the kind " + name +
                   "): assemble the store again");
}

std::vector<Advice> advice_of(const Json& json) {
  std::vector<Advice> all;
  for (const Json& one : json) {
    const auto number = [&](const char* name, std::size_t i) {
      return one.at(name).at(i).get<double>();
    };
    Advice advice;
    advice.kind = kind_of(one.at("kind").get<std::string>());
    advice.from = one.at("visits").at(0).get<AsrId>();
    advice.to = one.at("visits").at(1).get<AsrId>();
    advice.from_room = one.at("rooms").at(0).get<RoomId>();
    advice.to_room = one.at("rooms").at(1).get<RoomId>();
    advice.by_door = one.at("by_door").get<bool>();
    advice.drive_m = one.at("drive_m").get<double>();
    advice.place_before_m = number("place_m", 0);
    advice.place_after_m = number("place_m", 1);
    advice.heading_before_deg = number("heading_deg", 0);
    advice.heading_after_deg = number("heading_deg", 1);
    all.push_back(advice);
  }
  return all;
}

Judgement read(const Json& json) {
  Judgement judgement;
  judgement.probability = json.at("probability").get<double>();
  judgement.place_m = json.at("place_m").get<double>();
  judgement.heading_deg = json.at("heading_deg").get<double>();
  judgement.scale_share = json.at("scale_share").get<double>();
  judgement.figures = figures_of(json.at("figures"));
  for (const Json& room : json.at("rooms")) {
    judgement.rooms.push_back({room.at("room").get<RoomId>(), room.at("probability").get<double>(),
                               room.at("place_m").get<double>()});
  }
  for (const Json& doubt : json.at("doubts")) {
    judgement.doubts.push_back({doubt.at("text").get<std::string>(),
                                doubt.at("rooms").get<std::vector<RoomId>>(),
                                doubt.at("weight").get<double>()});
  }
  if (json.contains("advice"))
    judgement.advice = advice_of(json.at("advice"));  // not in stores of an earlier release
  for (const Json& visit : json.at("visits")) {
    judgement.visits.push_back({visit.at("asr").get<AsrId>(), visit.at("room").get<RoomId>(),
                                visit.at("probability").get<double>(),
                                visit.at("place_m").get<double>(),
                                figures_of(visit.at("figures"))});
  }
  return judgement;
}

}  // namespace

std::string to_json(const Judgement& judgement) {
  Json rooms = Json::array();
  for (const RoomJudgement& room : judgement.rooms) {
    rooms.push_back(
        {{"room", room.room}, {"probability", room.probability}, {"place_m", room.place_m}});
  }
  Json doubts = Json::array();
  for (const Doubt& doubt : judgement.doubts) {
    doubts.push_back({{"text", doubt.text}, {"rooms", doubt.rooms}, {"weight", doubt.weight}});
  }
  const Json json = {{"probability", judgement.probability},
                     {"place_m", judgement.place_m},
                     {"heading_deg", judgement.heading_deg},
                     {"scale_share", judgement.scale_share},
                     {"doubts", doubts},
                     {"advice", json_of(judgement.advice)},
                     {"rooms", rooms},
                     {"figures", json_of(judgement.figures)},
                     {"visits", visits_of(judgement)}};
  return json.dump();
}

std::optional<Judgement> judgement_of(const std::string& json) {
  if (json.empty()) return std::nullopt;
  try {
    return read(Json::parse(json));
  } catch (const Json::exception& error) {
    throw InputError(std::string("the judgement is damaged (") + error.what() +
                     "): assemble the store again");
  }
}

}  // namespace roomatlas
