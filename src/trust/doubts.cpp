// SPDX-License-Identifier: GPL-3.0-or-later
#include "doubts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "roomatlas/graph/bridges.hpp"

namespace roomatlas {
namespace {

constexpr double kWorthSaying = 0.5;  // log odds that a figure takes away
constexpr std::size_t kMost = 4;      // figures that are named
constexpr std::size_t kFewest = 3;    // visits behind a passage; fewer are the mission's end

/// What a figure that is worse than usual means.
struct Meaning {
  const char* figure;
  const char* text;
};
constexpr const char* kPulled = "what was heard contradicts itself and pulls visits about";
constexpr const char* kOtherwise = "solved by other means the rooms lie and turn otherwise";
constexpr Meaning kMeanings[] = {
    {"path", "the drive is long"},
    {"visits", "the mission has many visits"},
    {"echoes a reading", "a reading has few echoes"},
    {"seen again", "little was seen by more than one visit, so that little could contradict"},
    {"hits in free space", "visits hit what others looked through"},
    {"worst visit's hits in free space", "one visit hit what others looked through"},
    {"doubled walls", "walls that were seen again are doubled"},
    {"odometry's headings against the map's", "odometry turned otherwise than the map says"},
    {"odometry's lengths against the map's", "odometry drove other lengths than the map says"},
    {"odometry's steady drift", "odometry drifts steadily"},
    {"loops a visit", "few rooms were found again by their walls"},
    {"matches accepted", "many matches of rooms failed"},
    {"contradiction in matches", "rooms that were found again contradict each other"},
    {"strain of loops", "loops pull against each other"},
    {"place of a visit", "measurements between visits hold their places loosely"},
    {"place of the loosest visit", "one visit's place is held loosely"},
    {"passages in which the robot was lost", "the robot was lost on its way"},
    {"visits on one passage", "many visits hang on one passage"},
    {"contradiction of walls", "what one visit heard as wall, another heard through"},
    {"wall heard again", "little wall was heard by more than one visit"},
    {"stretches of wall a metre", "few stretches of wall were heard"},
    {"pairs of stretches", "few stretches of wall were heard again"},
    {"directions of the building",
     "parts of the building lie at an angle, which odometry alone tells"},
    {"unsure heading", "walls leave the heading unsure for parts of the drive"},
    {"undecided drives", "some drives could have gone forwards or backwards"},
    {"score of another winding", "another course of the heading explains the walls nearly as well"},
    {"heading of the loosest visit", "one visit's heading is held loosely"},
    {"visits held loosely",
     "walls and odometry leave open where rooms lie and how they are turned"},
    {"place by contradictions", kPulled},
    {"most a place is pulled by contradictions", kPulled},
    {"visits pulled by contradictions", kPulled},
    {"most a heading is pulled by contradictions",
     "what was heard contradicts itself and turns a visit to and fro"},
    {"uncertainty of the scale", "few walls tell how long odometry's metre is"},
    {"clutter before walls", "furniture or people stand before the walls"},
    {"strain of odometry", "walls pull odometry out of its way"},
    {"turned by directions", "the building's directions turn rooms that odometry puts otherwise"},
    {"attempts turned apart", "other directions of the building's walls fit nearly as well"},
    {"turned when solved otherwise", kOtherwise},
    {"visits moved when solved otherwise", kOtherwise},
    {"merit over the map solved otherwise", "solved by other means the walls fit nearly as well"},
    {"walls in directions", "few walls follow directions of the building"},
    {"attempts apart", "solutions that explain the walls nearly as well end elsewhere"},
    {"slips repaired", "the heading had slipped by a quarter turn and was put right"},
    {"odometry's bias", "odometry turns strongly while it drives"},
    {"odometry's gain", "odometry reports turns much too large or too small"},
};

/// Log odds; figures that mean the same are one.
std::map<std::string, double> taken_by_meaning(const LearntSum& right,
                                               const std::vector<JudgedFigure>& figures) {
  std::map<std::string, double> taken;
  for (const LearntTerm& term : right.terms) {
    const auto meaning =
        std::find_if(std::begin(kMeanings), std::end(kMeanings),
                     [&](const Meaning& one) { return std::string(one.figure) == term.name; });
    if (meaning != std::end(kMeanings)) taken[meaning->text] -= part_of(term, figures);
  }
  return taken;
}

/// "3", "7 to 12", "3, 5 and 7".
std::string list_of(const std::vector<RoomId>& rooms) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < rooms.size();) {
    std::size_t end = i + 1;
    while (end < rooms.size() && rooms[end] == rooms[end - 1] + 1) ++end;
    const std::string first = std::to_string(rooms[i]);
    if (end - i > 2) {
      parts.push_back(first + " to " + std::to_string(rooms[end - 1]));
    } else {
      for (std::size_t k = i; k < end; ++k) parts.push_back(std::to_string(rooms[k]));
    }
    i = end;
  }
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

std::vector<RoomId> rooms_of(const std::set<AsrId>& visits, const Assembly& assembly) {
  std::set<RoomId> inside;
  std::set<RoomId> outside;
  for (const auto& [asr, room] : assembly.room_of_asr) {
    (visits.contains(asr) ? inside : outside).insert(room);
  }
  std::vector<RoomId> rooms;
  for (const RoomId room : inside) {
    if (room != 0 && !outside.contains(room)) rooms.push_back(room);
  }
  return rooms;
}

/// Rooms that one passage alone holds to the rest, those behind the passage that holds most.
std::optional<Doubt> hanging(const Assembly& assembly) {
  std::optional<Bridge> most;
  for (const Bridge& bridge : bridges_of(assembly.graph)) {
    if (bridge.behind >= kFewest && (!most || bridge.behind > most->behind)) most = bridge;
  }
  if (!most) return std::nullopt;
  std::vector<RoomId> rooms = rooms_of(visits_behind(assembly.graph, *most), assembly);
  if (rooms.empty()) return std::nullopt;
  const std::string which = (rooms.size() == 1 ? "room " : "rooms ") + list_of(rooms);
  return Doubt{which + (rooms.size() == 1 ? " hangs" : " hang") + " on one passage",
               std::move(rooms), 0.0};
}

}  // namespace

std::vector<Doubt> doubts_of(const LearntSum& right, const std::vector<JudgedFigure>& figures,
                             const Assembly& assembly) {
  std::vector<Doubt> doubts;
  for (const auto& [text, taken] : taken_by_meaning(right, figures)) {
    if (taken >= kWorthSaying) doubts.push_back({text, {}, taken});
  }
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const Doubt& a, const Doubt& b) { return a.weight > b.weight; });
  if (doubts.size() > kMost) doubts.resize(kMost);
  if (assembly.doubted) {
    doubts.push_back(
        {"its sweeps, matched one by one, made another map, which was doubted", {}, 0.0});
  }
  if (!assembly.sonars) {
    if (auto doubt = hanging(assembly)) doubts.push_back(std::move(*doubt));
  }
  return doubts;
}

}  // namespace roomatlas
