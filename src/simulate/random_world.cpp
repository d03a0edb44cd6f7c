// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/simulate/random_world.hpp"

#include <stdexcept>
#include <string>

#include "random_world_kinds.hpp"
#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using namespace random_world_draft;

constexpr int kFewestRooms = 3;
constexpr int kMostRooms = 40;
constexpr double kUsualShare = 0.8;   // of buildings are of the usual size
constexpr double kTurnedShare = 0.5;  // of buildings stand at any angle

int drawn_rooms(RandomStream& random) {
  if (random.uniform() < kUsualShare) return whole_between(random, 5, 20);
  return whole_between(random, kFewestRooms, kMostRooms);
}

Draft draft_of(RandomWorldKind kind, RandomStream& random, const Style& style, int rooms) {
  switch (kind) {
    case RandomWorldKind::offices:
      return offices(random, style, rooms);
    case RandomWorldKind::long_corridor:
      return long_corridor(random, style, rooms);
    case RandomWorldKind::ring:
      return ring(random, style, rooms);
    case RandomWorldKind::equal_rooms: {
      Style equal = style;
      equal.equal = true;
      return offices(random, equal, rooms);
    }
    case RandomWorldKind::hall:
      return hall(random, style, rooms);
    case RandomWorldKind::open_plan:
      return open_plan(random, style, rooms);
    case RandomWorldKind::apartment:
      return apartment(random, style, rooms);
    case RandomWorldKind::wings:
      return wings(random, style, rooms);
    case RandomWorldKind::rotunda:
      return rotunda(random, style, rooms);
  }
  throw std::invalid_argument("unknown kind of random world");
}

}  // namespace

const char* to_string(RandomWorldKind kind) {
  switch (kind) {
    case RandomWorldKind::offices:
      return "offices";
    case RandomWorldKind::long_corridor:
      return "long_corridor";
    case RandomWorldKind::ring:
      return "ring";
    case RandomWorldKind::equal_rooms:
      return "equal_rooms";
    case RandomWorldKind::hall:
      return "hall";
    case RandomWorldKind::open_plan:
      return "open_plan";
    case RandomWorldKind::apartment:
      return "apartment";
    case RandomWorldKind::wings:
      return "wings";
    case RandomWorldKind::rotunda:
      return "rotunda";
  }
  return "";
}

RandomWorldKind kind_of(const RandomWorldOptions& options) {
  if (options.kind) return *options.kind;
  RandomStream random(options.seed, "random world kind");
  return static_cast<RandomWorldKind>(whole_between(random, 0, kRandomWorldKinds - 1));
}

FloorPlan random_world(const RandomWorldOptions& options) {
  if (options.rooms != 0 && (options.rooms < kFewestRooms || options.rooms > kMostRooms)) {
    throw UsageError("a random world has 3 to 40 rooms, not " + std::to_string(options.rooms));
  }
  const RandomWorldKind kind = kind_of(options);
  RandomStream random(options.seed, std::string("random world ") + to_string(kind));
  const Style style = drawn_style(random);
  const int drawn = drawn_rooms(random);
  const bool is_turned = random.uniform() < kTurnedShare;
  const double turned_rad = 2.0 * kPi * random.uniform();
  const Draft draft = draft_of(kind, random, style, options.rooms > 0 ? options.rooms : drawn);
  FloorPlan world = draft.plan(is_turned ? turned_rad : 0.0);
  world.title =
      std::string("Random world ") + std::to_string(options.seed) + ": " + to_string(kind);
  return world;
}

}  // namespace roomatlas
