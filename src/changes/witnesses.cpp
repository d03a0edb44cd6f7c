// SPDX-License-Identifier: GPL-3.0-or-later
#include "witnesses.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "roomatlas/grid/himm_grid.hpp"

namespace roomatlas::changes {
namespace {

constexpr std::int32_t kNone = -1;
constexpr double kMostMount_m = 2.0;  // of a sensor from the middle of its robot, and half a cell

/// A stretch of time; empty until something is added.
struct Span {
  double first_s = std::numeric_limits<double>::infinity();
  double last_s = -std::numeric_limits<double>::infinity();

  void add(double time_s) {
    first_s = std::min(first_s, time_s);
    last_s = std::max(last_s, time_s);
  }
  void add(const Span& other) {
    first_s = std::min(first_s, other.first_s);
    last_s = std::max(last_s, other.last_s);
  }
  [[nodiscard]] double length_s() const { return std::max(0.0, last_s - first_s); }
};

/// The cells of all groups, numbered, as one looks them up.
struct Asked {
  CellFrame frame;
  Raster<std::int32_t> number_of_cell;
  std::vector<std::size_t> group_of;  ///< by number
  std::size_t groups = 0;
};

Asked asked_of(const std::vector<CellGroup>& groups, double cell_m) {
  Asked asked{CellFrame{cell_m}, {}, {}, groups.size()};
  CellBox box;
  for (const CellGroup& group : groups) {
    for (const Cell& cell : group) {
      if (box.count() == 0) box = {cell, {cell.x + 1, cell.y + 1}};
      box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
      box.max = {std::max(box.max.x, cell.x + 1), std::max(box.max.y, cell.y + 1)};
    }
  }
  asked.number_of_cell = Raster<std::int32_t>(box, kNone);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const Cell& cell : groups[i]) {
      asked.number_of_cell[cell] = static_cast<std::int32_t>(asked.group_of.size());
      asked.group_of.push_back(i);
    }
  }
  return asked;
}

/// What the readings of one visit say.
struct Answer {
  std::vector<int> hits;    ///< by group
  std::vector<int> passes;  ///< by group
  std::vector<Span> spans;  ///< by group, of both
  std::vector<Span> cells;  ///< by number, of hits
};

/// What one reading met.
struct Met {
  std::vector<std::uint8_t> hit;     ///< by group
  std::vector<std::uint8_t> passed;  ///< by group
};

/// @param holds whether what the visit says of a cell still holds
template <typename Holds>
void follow(const std::vector<Ray>& rays, double time_s, const Asked& asked, Holds holds, Met& met,
            Answer& answer) {
  for (const Ray& ray : rays) {
    const Cell end = asked.frame.cell_of(ray.segment.b);
    for_each_cell_on_line(asked.frame.cell_of(ray.segment.a), end, [&](const Cell& cell) {
      const std::int32_t number = asked.number_of_cell.get(cell, kNone);
      if (number == kNone || !holds(cell)) return true;
      const std::size_t group = asked.group_of[static_cast<std::size_t>(number)];
      const bool is_end = cell == end;
      if (is_end && ray.ends_at_obstacle) {
        met.hit[group] = 1;
        answer.cells[static_cast<std::size_t>(number)].add(time_s);
      } else if (!is_end) {
        met.passed[group] = 1;
      }
      return true;
    });
  }
}

Answer answer_of(const Asr& asr, const AssembledMission& mission, const Asked& asked,
                 const GatherOptions& options) {
  const Pose2& building_from_asr = mission.placement.at(asr.id);
  const auto holds = [&](const Cell& cell) {
    return mission.times == nullptr || mission.times->holds(asr.id, cell);
  };
  const std::size_t groups = asked.groups;
  Answer answer{std::vector<int>(groups), std::vector<int>(groups), std::vector<Span>(groups),
                std::vector<Span>(asked.group_of.size())};
  std::int64_t ignored = 0;  // counted when each room was mapped
  const RayOptions rays{options.laser_range_m, options.sonar_no_echo_m, 0.0};
  for (std::size_t i = 0; i < asr.readings.size(); ++i) {
    const double time_s = asr.readings[i].timestamp_s;
    Met met{std::vector<std::uint8_t>(groups), std::vector<std::uint8_t>(groups)};
    follow(rays_of(asr.readings[i], building_from_asr * asr.path[i].asr_from_robot, rays, ignored),
           time_s, asked, holds, met, answer);
    for (std::size_t group = 0; group < groups; ++group) {
      if (met.hit[group] != 0) {
        ++answer.hits[group];
      } else if (met.passed[group] != 0) {
        ++answer.passes[group];
      } else {
        continue;
      }
      answer.spans[group].add(time_s);
    }
  }
  return answer;
}

/// The middle one of the lengths of a group's spans.
std::vector<double> medians(const std::vector<Span>& cells, const Asked& asked) {
  std::vector<std::vector<double>> lengths(asked.groups);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    lengths[asked.group_of[i]].push_back(cells[i].length_s());
  }
  std::vector<double> middle;
  for (std::vector<double>& of_group : lengths) {
    const auto at = of_group.begin() + static_cast<std::ptrdiff_t>(of_group.size() / 2);
    std::nth_element(of_group.begin(), at, of_group.end());
    middle.push_back(*at);
  }
  return middle;
}

}  // namespace

std::vector<AsrId> visits_near(const BuildingEvidence& evidence,
                               const std::vector<CellGroup>& groups, const GatherOptions& options) {
  std::vector<Box2> boxes;
  for (const CellGroup& group : groups) {
    Box2& box = boxes.emplace_back();
    for (const Cell& cell : group) box.extend(CellFrame{options.cell_m}.center_of(cell));
  }
  const double reach_m = options.laser_range_m + kMostMount_m;
  std::set<AsrId> near;
  for (std::size_t i = 0; i < evidence.building_from_robot.size(); ++i) {
    if (near.contains(evidence.asr_of_pose[i])) continue;
    const Point2 at = evidence.building_from_robot[i].position();
    const bool is_near = std::any_of(boxes.begin(), boxes.end(), [&](const Box2& box) {
      return (at - at.cwiseMax(box.min).cwiseMin(box.max)).norm() <= reach_m;
    });
    if (is_near) near.insert(evidence.asr_of_pose[i]);
  }
  return {near.begin(), near.end()};
}

std::vector<Witness> ask(const AssembledMission& mission, const std::vector<AsrId>& ids,
                         const std::vector<CellGroup>& groups, const GatherOptions& options,
                         const Progress& progress, int jobs) {
  if (groups.empty()) return {};
  const Asked asked = asked_of(groups, options.cell_m);
  const SharedSource source(*mission.source);
  const std::vector<Answer> answers = results_of<Answer>(
      ids.size(), jobs,
      [&](std::size_t i) {
        const Asr asr = source.load_with_readings(ids[i]);
        return answer_of(asr, mission, asked, options);
      },
      [&](std::size_t i) { report(progress, "ask all readings", share_of(i, ids.size())); });

  std::vector<Witness> witnesses(groups.size());
  std::vector<Span> spans(groups.size());
  std::vector<Span> cells(asked.group_of.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t group = 0; group < groups.size(); ++group) {
      if (answers[i].hits[group] + answers[i].passes[group] == 0) continue;
      witnesses[group].hits += answers[i].hits[group];
      witnesses[group].passes += answers[i].passes[group];
      witnesses[group].visits.push_back(ids[i]);
      spans[group].add(answers[i].spans[group]);
    }
    for (std::size_t cell = 0; cell < cells.size(); ++cell) cells[cell].add(answers[i].cells[cell]);
  }
  const std::vector<double> lasting_s = medians(cells, asked);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    if (!witnesses[group].visits.empty()) {
      witnesses[group].first_s = spans[group].first_s;
      witnesses[group].last_s = spans[group].last_s;
    }
    witnesses[group].lasting_s = lasting_s[group];
  }
  return witnesses;
}

}  // namespace roomatlas::changes
