// SPDX-License-Identifier: GPL-3.0-or-later
#include "advice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drives.hpp"
#include "roomatlas/loops/visit_graph.hpp"
#include "roomatlas/solve/added_edges.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kMostAdvice = 3;
constexpr double kWorthDriving = 0.1;  // of the measure below: less is not worth a drive

/// Both largest variances, each over what a visit may be off and still count as right.
double looseness(const LargestVariance& largest) {
  const double heading_rad = radians(kRightHeading_deg);
  return largest.position_m2 / (kRightPlace_m * kRightPlace_m) +
         largest.heading_rad2 / (heading_rad * heading_rad);
}

/// The covariances as the residuals enlarged them.
PoseGraph scaled(HeldVisits held) {
  for (PoseEdge& edge : held.measured.edges) {
    edge.information /= held.variance_factor;
    edge.cauchy_sigmas /= std::sqrt(held.variance_factor);
  }
  for (HeadingPrior& prior : held.measured.headings) {
    prior.sigma_rad *= std::sqrt(held.variance_factor);
  }
  return std::move(held.measured);
}

/// Of what was measured; of sonars, whose walls have no measurement there, of what was drawn.
AddedEdges held_now(const Assembly& assembly, HeldVisits held) {
  if (assembly.moves.drawn.empty()) return AddedEdges(scaled(std::move(held)));
  std::vector<std::vector<Pose2>> moves;
  for (const AsrVertex& vertex : assembly.graph.vertices) {
    moves.push_back(assembly.moves.drawn.at(vertex.asr));
  }
  return AddedEdges(held.measured.guess, moves);
}

/// In the same words: a way is advised once.
bool is_advised(const Advice& drive, const std::vector<Advice>& advice) {
  return std::any_of(advice.begin(), advice.end(),
                     [&](const Advice& other) { return words(other) == words(drive); });
}

Advice said_of(const Drive& drive, const LargestVariance& before, const LargestVariance& after) {
  Advice advice = drive.advice;
  advice.place_before_m = std::sqrt(before.position_m2);
  advice.place_after_m = std::sqrt(after.position_m2);
  advice.heading_before_deg = degrees(std::sqrt(before.heading_rad2));
  advice.heading_after_deg = degrees(std::sqrt(after.heading_rad2));
  return advice;
}

}  // namespace

std::vector<Advice> advice_on(const Assembly& assembly, const CorrectOptions& correct) {
  HeldVisits held = held_visits_of(assembly.graph, assembly.closures, assembly.correction, correct);
  if (held.measured.edges.empty() || held.measured.ids.size() > kMostAdvised) return {};
  const double variance_factor = held.variance_factor;
  AddedEdges added = held_now(assembly, std::move(held));
  if (!added.is_held()) return {};
  const std::vector<Drive> drives = drives_of(assembly, correct, added, variance_factor);
  std::vector<Advice> advice;
  LargestVariance before = added.now();
  while (advice.size() < kMostAdvice) {
    const Drive* best = nullptr;
    LargestVariance after_best;
    double best_a_metre = 0.0;
    for (const Drive& drive : drives) {
      if (is_advised(drive.advice, advice)) continue;
      const LargestVariance after = added.with({&drive.edge, 1});
      const double gained = looseness(before) - looseness(after);
      if (gained < kWorthDriving * looseness(before)) continue;
      if (gained / drive.advice.drive_m <= best_a_metre) continue;
      best = &drive;
      best_a_metre = gained / drive.advice.drive_m;
      after_best = after;
    }
    if (best == nullptr) break;
    advice.push_back(said_of(*best, before, after_best));
    added.add({&best->edge, 1});
    before = after_best;
  }
  return advice;
}

}  // namespace roomatlas
