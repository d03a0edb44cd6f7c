// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/feed_back.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace roomatlas {
namespace {

/// For each ASR itself and those that lie on it, ascending.
std::map<AsrId, std::set<AsrId>> overlapping(const std::vector<AsrShape>& shapes,
                                             const std::vector<Closure>& closures) {
  std::map<AsrId, std::set<AsrId>> of;
  for (const AsrShape& shape : shapes) of[shape.id].insert(shape.id);
  for (const Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    of[closure.from].insert(closure.to);
    of[closure.to].insert(closure.from);
  }
  return of;
}

/// The faces of all shapes in the frame of one.
LocalMap faces_around(const Pose2& building_from_map, const std::set<AsrId>& ids,
                      const std::map<AsrId, const AsrShape*>& shape_of, const Placement& placement,
                      double min_hits) {
  LocalMap map(shape_of.at(*ids.begin())->map.frame().cell_m);
  for (const AsrId id : ids) {
    const Pose2 map_from_asr = inverse(building_from_map) * placement.at(id);
    const PointTransform place(map_from_asr);
    const PointTransform turn({0.0, 0.0, map_from_asr.theta_rad});
    for (const Face& face : shape_of.at(id)->map.faces(min_hits)) {
      map.add(Face{place * face.position, turn * face.normal, face.hits});
    }
  }
  return map;
}

/// The path of an ASR, each pose where its reading fits the map.
std::vector<Pose2> matched_path(const Asr& asr, const LocalMap& map,
                                const FeedBackOptions& options) {
  std::vector<Pose2> path;
  for (std::size_t i = 0; i < asr.readings.size(); ++i) {
    const Pose2& was = asr.path[i].asr_from_robot;
    const ScanAlignment aligned =
        align(map, thinned(scan_of(asr.readings[i], options.scan).points, options.max_points), was,
              PosePrior{was, options.position_sigma_m, options.heading_sigma_rad}, options.align);
    const bool is_matched = aligned.matched > options.min_matched &&
                            aligned.matched > options.min_matched_share * aligned.points;
    path.push_back(is_matched ? aligned.map_from_points : was);
  }
  return path;
}

}  // namespace

Paths feed_back(const AsrSource& source, const std::vector<AsrShape>& shapes,
                const std::vector<Closure>& closures, const Placement& placement,
                const FeedBackOptions& options) {
  std::map<AsrId, const AsrShape*> shape_of;
  for (const AsrShape& shape : shapes) shape_of[shape.id] = &shape;
  Paths paths;
  for (const auto& [id, ids] : overlapping(shapes, closures)) {
    const LocalMap map =
        faces_around(placement.at(id), ids, shape_of, placement, options.min_face_hits);
    paths[id] = matched_path(source.get(id, AsrDetail::readings), map, options);
  }
  return paths;
}

}  // namespace roomatlas
