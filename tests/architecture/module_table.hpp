// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace roomatlas::architecture {

/// Which modules a module may include, beside itself: those below it that it needs, and none that
/// it does not. The table of docs/architecture.md: who changes one changes the other. `apps` may
/// include anything and is not listed.
inline const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {}},
    {"plan", {"core"}},
    {"mission", {"core"}},
    {"grid", {"core", "mission"}},
    {"polyline", {"core", "grid"}},
    {"odometry", {"core", "mission"}},
    {"match", {"core", "mission", "grid", "odometry"}},
    {"asr", {"core", "plan", "mission", "grid", "polyline", "match"}},
    {"graph", {"core", "asr"}},
    {"solve", {"core"}},
    {"sonar", {"core", "mission", "odometry", "solve"}},
    {"correct", {"core", "odometry", "asr", "graph", "solve"}},
    {"loops", {"core", "match", "asr", "solve", "correct"}},
    {"rooms", {"core", "plan", "mission", "grid", "polyline", "asr", "graph"}},
    {"planar", {"core"}},
    {"draft", {"core", "plan", "mission", "grid", "polyline", "asr", "graph", "rooms", "planar"}},
    {"edit", {"core", "plan", "rooms", "planar"}},
    {"changes", {"core", "plan", "mission", "grid", "polyline", "match", "asr", "draft", "planar"}},
    {"merge", {"core", "plan", "planar"}},
    {"locate", {"core", "grid", "match", "asr", "sonar", "loops"}},
    {"join", {"core", "mission", "grid", "solve", "loops", "locate"}},
    {"assembly", {"core", "plan", "asr", "graph", "sonar", "correct", "loops", "mission"}},
    {"evaluate", {"core", "plan", "polyline", "asr", "correct", "loops", "assembly", "planar"}},
    {"trust",
     {"core", "plan", "mission", "asr", "graph", "solve", "correct", "loops", "assembly",
      "evaluate"}},
    {"draw", {"core", "plan", "asr"}},
    {"simulate", {"core", "plan", "mission", "grid", "polyline", "asr", "planar"}},
    {"pipeline", {"core",     "mission",  "odometry", "match",  "asr",  "graph",   "sonar",
                  "correct",  "loops",    "rooms",    "draft",  "edit", "changes", "merge",
                  "assembly", "evaluate", "trust",    "locate", "join", "plan"}},
    {"io",
     {"core", "plan", "mission", "grid", "odometry", "match", "asr", "graph", "solve", "correct",
      "loops", "planar", "edit", "merge", "evaluate", "draw", "simulate", "assembly"}},
};

/// The header of the whole library. It belongs to no module and may include any; for programs, not
/// for the library itself.
inline const std::string kUmbrella = "roomatlas/roomatlas.hpp";

}  // namespace roomatlas::architecture
