// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "explorer_map.hpp"
#include "explorer_paths.hpp"
#include "explorer_rooms.hpp"
#include "steering.hpp"

#include <cstdint>
#include <optional>
#include <unordered_set>

namespace roomatlas {

/// Decides where the robot goes, from its readings alone.
class Explorer {
 public:
  explicit Explorer(const SimulationOptions& options);

  /// Takes one reading and says what to do in the next period; nothing when all is explored, or
  /// when the robot cannot move any more.
  /// @param bumped the last step was not made, because the robot touched something
  [[nodiscard]] std::optional<Steering> decide(const RangeReading& reading,
                                               const Pose2& map_from_robot, bool bumped);

  [[nodiscard]] const ExplorerRooms& rooms() const { return rooms_; }
  [[nodiscard]] std::int64_t goals_given_up() const { return goals_given_up_; }
  [[nodiscard]] bool is_stuck() const { return is_stuck_; }

 private:
  /// Where the robot is going: a frontier of its map, or through a door.
  struct Goal {
    std::optional<ExplorerRooms::Door> door;
    ExplorerRooms::Room from = 0;  ///< the room in which it was chosen
    bool ignores_doors = false;    ///< left over, wherever it is
    bool is_look = false;          ///< a place to look from, done when the robot is there
    double deadline_s = 0.0;
    Polyline way;
  };

  void sense(const RangeReading& reading, const Pose2& map_from_robot);
  void follow_rooms(const Pose2& map_from_robot);
  void look_behind(const Pose2& map_from_robot);
  [[nodiscard]] std::optional<ExplorerRooms::Room> known_room_here(const Point2& position);

  [[nodiscard]] std::optional<Steering> step_back(const Point2& position);
  [[nodiscard]] Steering next_step(const Pose2& map_from_robot);
  [[nodiscard]] bool is_caught(const Pose2& map_from_robot);
  void get_away(bool bumped, const Point2& position);
  [[nodiscard]] std::optional<Goal> next_goal(const Point2& position);
  [[nodiscard]] std::optional<Goal> next_new_goal(const Point2& position);
  [[nodiscard]] std::optional<Goal> frontier_goal(const Point2& position);
  [[nodiscard]] std::optional<Goal> door_goal(ExplorerRooms::Door door, const Point2& position);
  [[nodiscard]] std::optional<Polyline> way_through(ExplorerRooms::Door door,
                                                    const Point2& position);
  [[nodiscard]] std::optional<Polyline> way_to(const Point2& target, bool ignores_doors,
                                               const Point2& position);
  [[nodiscard]] std::optional<Goal> leftover_goal(const Point2& position);
  [[nodiscard]] std::optional<Goal> look_goal(const Point2& position);
  [[nodiscard]] bool is_worth_a_look(const Cell& cell) const;
  [[nodiscard]] bool opens_a_gap(const Cell& cell) const;
  [[nodiscard]] bool is_in_unused_doorway(const Cell& cell) const;
  bool find_doorway_on(const Polyline& way, const Point2& position);
  [[nodiscard]] bool is_done(const Goal& goal) const;
  [[nodiscard]] bool is_around(const Goal& goal, const Point2& position);
  [[nodiscard]] bool renew(Goal& goal, const Point2& position);
  void give_up(const Goal& goal, const Point2& position);
  void want_no_more(const Cell& around);
  [[nodiscard]] bool is_wanted_frontier(const Cell& cell) const;
  [[nodiscard]] double deadline_s(const Polyline& way) const;

  static constexpr double kStuckM = 0.15;  ///< a robot that moved less is where it was

  SimulationOptions options_;
  SteeringLimits limits_;
  ExplorerMap map_;
  PathFinder paths_;
  ExplorerRooms rooms_;
  std::optional<Goal> goal_;
  std::optional<ExplorerRooms::Door> zone_;  ///< the door in which the robot stands
  std::unordered_set<std::int64_t> given_up_;
  std::optional<Pose2> last_mapped_;
  std::vector<Cell> to_look_from_;  ///< at the end; asked again before each is a goal
  Polyline track_;                  ///< where the robot has been
  Point2 last_moved_ = Point2::Zero();
  CloseEchoes echoes_;
  Trace trace_;
  std::optional<Steering> last_step_;  ///< to be added to the trace, once made
  bool is_retreating_ = false;
  Pose2 last_progress_;      ///< where the robot was when it last got on ...
  double progress_s_ = 0.0;  ///< ... and when
  double shuffle_end_s_ = 0.0;
  int shuffles_ = 0;
  Point2 caught_at_ = Point2::Zero();  ///< where it last had to shuffle ...
  int caught_ = 0;                     ///< ... and how often, there
  double time_s_ = 0.0;
  double renew_s_ = 0.0;
  std::int64_t goals_given_up_ = 0;
  int given_up_here_ = 0;  ///< without moving
  bool has_tried_again_ = false;
  bool is_stuck_ = false;
};

}  // namespace roomatlas
