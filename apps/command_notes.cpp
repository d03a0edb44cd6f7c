// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_notes.hpp"

#include <map>
#include <stdexcept>

namespace roomatlas::apps {
namespace {

using enum Stage;

const char* const kToPlan = "From a log to a plan";
const char* const kWithPlan = "What is done with a plan";
const char* const kTools = "Tools";

const std::map<std::string, CommandNotes>& all_notes() {
  static const std::map<std::string, CommandNotes> notes = {
      {"info",
       {kToPlan,
        {mission},
        {{"roomatlas info my_bag", "topics and frames of a recording, and what would be mapped"}}}},
      {"build",
       {kToPlan,
        {mission, rooms, correction, plan, run},
        {{"roomatlas build my_bag -o out", "a recording of topics to a plan in the folder out"},
         {"roomatlas build monday.clf tuesday.mcap -o out", "two missions of one building, joined"},
         {"roomatlas build map.yaml -o out", "a finished map of any SLAM program"}}}},
      {"map",
       {kToPlan,
        {mission, rooms, run},
        {{"roomatlas map mission.clf -o building.gpkg", "the first half of `build`"}}}},
      {"assemble",
       {kToPlan,
        {rooms, correction, plan, run},
        {{"roomatlas assemble building.gpkg --plan traced", "the second half, otherwise"}}}},
      {"join",
       {kToPlan,
        {rooms, correction, plan, run},
        {{"roomatlas join a.gpkg b.gpkg -o building.gpkg", "two missions that share rooms"}}}},
      {"locate",
       {kWithPlan,
        {mission, rooms, run},
        {{"roomatlas locate building.gpkg today.clf --to 60",
          "where its first minute was driven"}}}},
      {"export",
       {kWithPlan,
        {plan},
        {{"roomatlas export building.gpkg -o out", "all formats"},
         {"roomatlas export building.gpkg -o out -f pdf,dxf", "two of them"},
         {"roomatlas export building.gpkg -o out --georef 48.0130,7.8335,12.5",
          "with a plan in longitude and latitude"},
         {"roomatlas export building.gpkg -o out -f imdf --georef 48.0130,7.8335,12.5",
          "for Microsoft Places"}}}},
      {"evaluate",
       {kWithPlan,
        {mission, plan},
        {{"roomatlas evaluate building.gpkg --truth truth.geojson", "a plan against the true one"},
         {"roomatlas evaluate a.tum b.tum --truth truth.tum", "two trajectories, side by side"}}}},
      {"compare",
       {kWithPlan,
        {plan, run},
        {{"roomatlas compare may.gpkg june.gpkg -o changes", "doors shut, furniture moved"}}}},
      {"report",
       {kWithPlan,
        {mission, plan},
        {{"roomatlas report building.gpkg -o report.html", "one file for the browser"}}}},
      {"rename",
       {kWithPlan, {}, {{"roomatlas rename building.gpkg 3 Kitchen", "room 3 is the kitchen"}}}},
      {"inspect",
       {kWithPlan,
        {rooms, plan},
        {{"roomatlas inspect building.gpkg 7 -o out", "how visit 7 became a room"}}}},
      {"simulate",
       {kTools,
        {mission, simulation},
        {{"roomatlas simulate plan.local.geojson -o sim --sensor laser", "through a plan"},
         {"roomatlas simulate map.yaml -o sim", "through a finished map"},
         {"roomatlas simulate --random-world 7 -o sim", "through a building that is made up"}}}},
      {"convert",
       {kTools,
        {mission},
        {{"roomatlas convert mission.clf -o mission.mcap", "a log for tools that read topics"}}}},
      {"optimize",
       {kTools,
        {},
        {{"roomatlas optimize graph.g2o -o solved.g2o --robust", "without false closures"}}}},
      {"config",
       {kTools,
        {mission, rooms, correction, plan, simulation},
        {{"roomatlas config --print > my.toml",
          "all parameters, to be changed and given with "
          "--config my.toml"}}}},
      {"completion",
       {"", {}, {{"source <(roomatlas completion bash)", "for this shell, from now on"}}}},
      {"man", {"", {}, {{"roomatlas man build | man -l -", "the page of one command"}}}},
  };
  return notes;
}

}  // namespace

const CommandNotes& notes_of(const std::string& command) {
  const auto found = all_notes().find(command);
  if (found == all_notes().end()) throw std::logic_error("command without notes: " + command);
  return found->second;
}

}  // namespace roomatlas::apps
