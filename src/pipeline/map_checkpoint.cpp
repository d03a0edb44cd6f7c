// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/pipeline/map_checkpoint.hpp"

#include <algorithm>
#include <cmath>

#include "roomatlas/core/issue.hpp"
#include "roomatlas/core/packed.hpp"

namespace roomatlas {
namespace {

constexpr std::uint32_t kVersion = 1;  ///< changes with what is packed, or what it means

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
}

/// Whether a run can have left this: what is used to count or to find something is in range.
bool is_possible(const MapCheckpoint& it) {
  const RoomEntered& room = it.room;
  const auto begun_with = static_cast<std::int64_t>(room.seed.size() + room.path.size());
  const bool all_finite = std::all_of(room.seed.begin(), room.seed.end(), is_finite) &&
                          std::all_of(room.path.begin(), room.path.end(), is_finite) &&
                          is_finite(room.odom_from_asr) && is_finite(room.reckoned_from_robot) &&
                          is_finite(it.odometry.last_reckoned_from_robot);
  const bool has_a_kind = !room.entry || room.entry->kind == PassageKind::doorway ||
                          room.entry->kind == PassageKind::open_passage;
  return room.asr > 1 && !room.path.empty() && begun_with <= it.readings &&
         it.readings <= it.events && it.true_poses >= 0 && all_finite && has_a_kind;
}

}  // namespace

template <MaybeConst<Exit> Value, typename Visit>
void fields_of(Value& exit, Visit& visit) {
  visit(exit.frame_from_pivot, exit.width_m, exit.jambs.a, exit.jambs.b, exit.kind, exit.is_entry,
        exit.neighbor, exit.timestamp_s);
}
template <MaybeConst<RoomEntered> Value, typename Visit>
void fields_of(Value& room, Visit& visit) {
  visit(room.asr, room.odom_from_asr, room.entry, room.seed, room.path, room.reckoned_from_robot,
        room.since_doorway_m, room.learnt);
}
template <MaybeConst<MapCheckpoint> Value, typename Visit>
void fields_of(Value& it, Visit& visit) {
  visit(it.events, it.readings, it.true_poses, it.wall_vertices, it.odometry, it.room);
}

std::string to_bytes(const MapCheckpoint& checkpoint) {
  Packer packer;
  packer(kVersion, checkpoint);
  return std::move(packer).bytes();
}

MapCheckpoint map_checkpoint_of(const std::string& bytes) {
  std::uint32_t version = 0;
  MapCheckpoint checkpoint;
  bool is_whole = false;
  try {
    Unpacker unpacker(bytes);
    unpacker(version);
    if (version == kVersion) {
      unpacker(checkpoint);
      is_whole = unpacker.is_at_end() && is_possible(checkpoint);
    }
  } catch (const std::logic_error&) {  // it ends too early
  }
  if (version != kVersion) {
    throw InputError("its checkpoint has version " + std::to_string(version) + ", expected " +
                     std::to_string(kVersion));
  }
  if (!is_whole) throw InputError("its checkpoint is damaged");
  return checkpoint;
}

}  // namespace roomatlas
