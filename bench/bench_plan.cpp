// SPDX-License-Identifier: GPL-3.0-or-later
// How good plans are: a table with a line for each mission, judged against the world it was
// simulated in (or, for fr079, against labelled rooms). Runs the built program itself. Markdown on
// stdout, each line on stderr too as soon as it is known.
//
//   bench_plan [--pictures] [--again] [--map-again] [--assemble FLAG]... [WISH...]
//     WISH         cases that have all its words in their group or name: worlds, maps, fr079,
//                  "worlds sonar", "nine_rooms furnished laser"; without any worlds and fr079;
//                  maps take hours
//     --pictures   out/plan/CASE/pictures/plan.svg
//     --again      simulates and maps again; else missions of the same arguments are taken again
//     --map-again  maps again, for a change of the online stage
//     --assemble   a further word for `roomatlas assemble`, to try a parameter
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "plan/plan_cases.hpp"
#include "plan/plan_run.hpp"
#include "plan/plan_table.hpp"
#include "recorded_data.hpp"

namespace {

using namespace roomatlas::bench;

struct Choice {
  PlanRunOptions options;
  std::vector<std::string> wishes;

  [[nodiscard]] bool includes(const PlanCase& one) const {
    return std::any_of(wishes.begin(), wishes.end(),
                       [&](const std::string& wish) { return is_wished(one, wish); });
  }
};

Choice choice_of(const std::vector<std::string>& words) {
  Choice choice;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--pictures") {
      choice.options.with_pictures = true;
    } else if (words[i] == "--again") {
      choice.options.simulate_again = true;
    } else if (words[i] == "--map-again") {
      choice.options.map_again = true;
    } else if (words[i] == "--assemble" && i + 1 < words.size()) {
      choice.options.assemble.push_back(words[++i]);
    } else {
      choice.wishes.push_back(words[i]);
    }
  }
  if (choice.wishes.empty()) choice.wishes = {"worlds", "fr079"};
  return choice;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path source = ROOMATLAS_SOURCE_DIR;
  const Choice choice = choice_of({argv + 1, argv + argc});
  std::vector<PlanRow> rows;
  for (const PlanCase& one : plan_cases(source / "data" / "worlds", recorded_data())) {
    if (!choice.includes(one)) continue;
    rows.push_back(run_plan_case(one, source / "out" / "plan", choice.options));
    std::fprintf(stderr, "%s", plan_line(rows.back()).c_str());
  }
  if (rows.empty()) {
    std::fprintf(stderr, "no case has those words; bench/plan/plan_cases.cpp has their names\n");
    return 2;
  }
  std::printf("%s", plan_table(rows).c_str());
  return 0;
}
