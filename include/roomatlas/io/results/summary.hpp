// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "roomatlas/evaluate/evaluation.hpp"
#include "roomatlas/graph/room_graph.hpp"
#include "roomatlas/mission/mission.hpp"
#include "roomatlas/odometry/habits.hpp"
#include "roomatlas/plan/answers.hpp"
#include "roomatlas/plan/floor_plan.hpp"
#include "roomatlas/plan/judgement.hpp"
#include "roomatlas/plan/seen_last.hpp"
#include "roomatlas/simulate/explore.hpp"

namespace roomatlas {

/// The mission as one JSON object, without times of this run, hosts or paths: the log's file name
/// alone.
[[nodiscard]] std::string to_json(const MissionInfo& info);

/// Which of several answers a map is, as one JSON object.
[[nodiscard]] std::string to_json(const Answers& answers);
/// What a store keeps of them, one answer where it keeps nothing.
/// @throws InputError where its text is none of `to_json`
[[nodiscard]] Answers answers_in(const std::map<std::string, std::string>& metadata);

/// Where visits lie: {"visits": [[visit, x (m), y (m), heading (rad)], ...]}.
[[nodiscard]] std::string to_json(const Placement& placement);
/// That of the answer that a map is not, see `Assembly::other_answer`.
[[nodiscard]] Placement other_answer_in(const std::map<std::string, std::string>& metadata);

/// What is drawn as later missions saw it, as one JSON object.
[[nodiscard]] std::string to_json(const std::vector<SeenLast>& seen_last);

/// What had to be done about odometry, as one JSON object.
[[nodiscard]] std::string to_json(const OdometryHabits& habits);

/// All figures of an evaluation as one JSON object; statistics of nothing are null.
/// @param judgement of the map, becomes "judgement" where there is one
/// @param answers text of the map's "answers", where it has several
[[nodiscard]] std::string to_json(const Evaluation& evaluation,
                                  const std::optional<Judgement>& judgement = std::nullopt,
                                  const std::string& answers = "");

/// What an exploration came to, as one JSON object.
[[nodiscard]] std::string to_json(const ExploreSummary& summary, const FloorPlan& world);

/// `summary.json`: mission, plan, graph, correction with what moved each ASR, evaluation.
/// @param metadata of the store; `mission_json` in it becomes the object "mission"
[[nodiscard]] std::string summary_json(const std::map<std::string, std::string>& metadata,
                                       const Correction& correction, const FloorPlan& plan,
                                       const RoomGraph& graph,
                                       const std::optional<Evaluation>& evaluation);

}  // namespace roomatlas
