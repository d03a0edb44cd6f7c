// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/random_building.hpp"

#include "random_building_robot.hpp"
#include "roomatlas/core/issue.hpp"

#include <algorithm>
#include <cmath>

namespace roomatlas {
namespace {

using namespace random_building_layout;

constexpr double kBeforeDoorM = 0.7;  // the robot stands here before it drives through a door

void require_usable(const RandomBuildingOptions& options) {
  if (options.rooms < 1) throw UsageError("a random building needs at least one room");
  const auto is_length = [](double value) { return std::isfinite(value) && value >= 0.0; };
  if (!is_length(options.vertex_noise_m) || !is_length(options.jamb_noise_m)) {
    throw UsageError("the noise of vertices and jambs must be 0 m or more");
  }
  const auto is_positive = [&](double value) { return is_length(value) && value > 0.0; };
  if (!is_positive(options.sample_every_m) || !is_positive(options.max_piece_path_m) ||
      !is_positive(options.speed_m_per_s)) {
    throw UsageError("sample distance, longest piece and speed must be more than 0");
  }
}

Point2 middle_of(const Box2& box) { return (box.min + box.max) / 2.0; }

Point2 before(const LaidOpening& opening) {
  return opening.world_from_pivot * Point2(-kBeforeDoorM, 0.0);
}

/// Something that the robot does on its way along a corridor.
struct Stop {
  double along_m = 0.0;  ///< of the door by which it leaves the corridor
  std::vector<std::size_t> spaces;
};

/// The drive through the building: along each corridor, into every room and through every door.
class Tour {
 public:
  Tour(const RandomBuildingOptions& options, const Layout& layout, AsrSink& sink,
       const std::function<void(const TrueVisit&)>& truth)
      : layout_(layout), block_(layout.block(0)), random_(options.seed, "building tour") {
    const Box2& box = block_.corridor().box;
    robot_.emplace(options, sink, truth, block_.corridor(),
                   Pose2{box.min.x() + kBeforeDoorM, middle_of(box).y(), 0.0});
  }

  RandomBuildingSummary drive() {
    for (std::int64_t index = 0;; ++index) {
      visit_rooms();
      doors_ += static_cast<std::int64_t>(block_.doors.size());
      if (index + 1 == layout_.blocks()) break;
      Block next = layout_.block(index + 1);
      if (next.strip == block_.strip) {
        along_corridor_to(next.corridor().id);
        cross(next.corridor());
      } else {
        change_strip(next);
      }
      next_block(std::move(next));
    }
    if (layout_.blocks() == 1) {  // a corridor without rooms would be a single pose
      const Box2& box = block_.corridor().box;
      robot_->go_to({box.max.x() - kBeforeDoorM, middle_of(box).y()});
    }
    robot_->finish();
    RandomBuildingSummary summary = robot_->summary();
    summary.doors = doors_;
    return summary;
  }

 private:
  /// The robot's space is in `next` by now; it must not move in memory.
  void next_block(Block next) {
    done_link_ = next.strip == block_.strip ? std::nullopt : next.south_link;
    block_ = std::move(next);
  }

  void cross(const Space& next) { robot_->cross(*opening_to(robot_->space(), next.id), next); }

  /// To the door of a room, along the middle of the corridor.
  void along_corridor_to(RoomId room) {
    const double y = middle_of(block_.corridor().box).y();
    const Point2 door = before(*opening_to(block_.corridor(), room));
    robot_->go_to({robot_->position().x(), y});
    robot_->go_to({door.x(), y});
  }

  /// Some place in the middle half of the room, then to the door of another.
  void through_room_to(const Space& next) {
    const Box2& box = robot_->space().box;
    const double x = 0.5 * (random_.uniform() - 0.5);
    const double y = 0.5 * (random_.uniform() - 0.5);
    robot_->go_to(middle_of(box) + box.size().cwiseProduct(Point2(x, y)));
    leave_to(next);
  }
  void leave_to(const Space& next) {
    robot_->go_to(before(*opening_to(robot_->space(), next.id)));
    cross(next);
  }

  /// Out into the corridor and back: a door that would else not be driven through.
  void look_out(const Space& room) {
    leave_to(block_.corridor());
    robot_->go_to({robot_->position().x(), middle_of(block_.corridor().box).y()});
    leave_to(room);
  }

  void visit_rooms() {
    std::vector<Stop> stops;
    const int heading = Layout::heading_of(block_.strip);
    const auto add = [&](std::vector<std::size_t> spaces) {
      const LaidOpening* door = opening_to(block_.corridor(), block_.spaces[spaces.front()].id);
      stops.push_back({heading * door->world_from_pivot.x_m, std::move(spaces)});
    };
    for (const auto& chain : block_.chains) add(chain);
    const bool turns = changes_strip();
    if (block_.south_link && block_.south_link != done_link_) add({*block_.south_link});
    if (block_.north_link && !turns) add({*block_.north_link});
    std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
      return std::pair(a.along_m, a.spaces) < std::pair(b.along_m, b.spaces);
    });
    for (const Stop& stop : stops) {
      const bool is_link =
          stop.spaces.front() == block_.south_link || stop.spaces.front() == block_.north_link;
      if (is_link) {
        visit_link(stop.spaces.front());
      } else {
        visit_chain(stop.spaces);
      }
    }
  }

  [[nodiscard]] bool changes_strip() const {
    return block_.index + 1 < layout_.blocks() &&
           !layout_.index_at(block_.strip, block_.column + Layout::heading_of(block_.strip));
  }

  /// Through rooms that are joined side by side, and back along the corridor.
  void visit_chain(const std::vector<std::size_t>& chain) {
    const RoomId first = block_.spaces[chain.front()].id;
    along_corridor_to(first);
    cross(block_.spaces[chain.front()]);
    const std::size_t last = chain.size() - 1;
    const bool ends_blind = !opening_to(block_.spaces[chain[last]], block_.corridor().id);
    const std::size_t way_out = ends_blind ? last - 1 : last;
    for (std::size_t i = 1; i <= last; ++i) {
      through_room_to(block_.spaces[chain[i]]);
      if (i < way_out) look_out(block_.spaces[chain[i]]);
    }
    if (ends_blind) through_room_to(block_.spaces[chain[way_out]]);
    through_room_to(block_.corridor());
    if (chain.size() > 1) along_corridor_to(first);
  }

  /// Into the link room, through the door to the next row where there is one, and back.
  void visit_link(std::size_t link) {
    const Space& room = block_.spaces[link];
    along_corridor_to(room.id);
    cross(room);
    const bool is_north = link == block_.north_link;
    const auto beyond = layout_.index_at(block_.strip + (is_north ? 1 : -1), block_.column);
    if (beyond) {
      beyond_ = layout_.block(*beyond);
      const auto& other = is_north ? beyond_.south_link : beyond_.north_link;
      through_room_to(beyond_.spaces[*other]);
      through_room_to(room);
    }
    through_room_to(block_.corridor());
  }

  void change_strip(const Block& next) {
    along_corridor_to(block_.spaces[*block_.north_link].id);
    cross(block_.spaces[*block_.north_link]);
    through_room_to(next.spaces[*next.south_link]);
    through_room_to(next.corridor());
  }

  const Layout& layout_;
  Block block_;
  Block beyond_;  ///< of the next row, for a look at its link room
  RandomStream random_;
  std::optional<std::size_t> done_link_;  ///< by which the robot came into this block
  std::optional<RandomBuildingRobot> robot_;
  std::int64_t doors_ = 0;
};

}  // namespace

RandomBuildingSummary random_building(const RandomBuildingOptions& options, AsrSink& sink,
                                      const std::function<void(const TrueVisit&)>& truth) {
  require_usable(options);
  const Layout layout(options.rooms, options.seed);
  RandomBuildingSummary summary = Tour(options, layout, sink, truth).drive();
  summary.rooms = options.rooms;
  return summary;
}

}  // namespace roomatlas
