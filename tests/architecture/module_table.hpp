// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace roomatlas::architecture {

/// Which modules a module may include, beside itself. The table of docs/architecture.md: who
/// changes one changes the other. `apps` may include anything and is not listed.
inline const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"core", {}},
    {"mission", {"core"}},
    {"grid", {"core", "mission"}},
    {"polyline", {"core", "grid"}},
    {"match", {"core", "mission", "grid", "polyline"}},
    {"asr", {"core", "mission", "grid", "polyline", "match"}},
    {"graph", {"core", "mission", "grid", "polyline", "match", "asr"}},
    {"correct", {"core", "mission", "match", "asr", "graph"}},
    {"merge", {"core", "asr", "graph", "correct"}},
    {"evaluate", {"core", "mission", "polyline", "asr", "graph", "correct", "merge"}},
    {"draw", {"core", "asr", "graph", "correct", "merge", "evaluate"}},
    {"simulate", {"core", "mission", "grid", "asr", "graph", "merge"}},
    {"io",
     {"core", "mission", "grid", "polyline", "match", "asr", "graph", "correct", "merge", "draw",
      "evaluate", "simulate", "pipeline"}},
    {"pipeline",
     {"core", "mission", "grid", "polyline", "match", "asr", "graph", "correct", "merge", "draw",
      "evaluate"}},
};

}  // namespace roomatlas::architecture
