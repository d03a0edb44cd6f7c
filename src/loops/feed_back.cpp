// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/loops/feed_back.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "roomatlas/asr/shared_source.hpp"
#include "roomatlas/core/for_each_index.hpp"

namespace roomatlas {
namespace {

/// For each ASR itself and those that lie on it, ascending.
std::map<AsrId, std::set<AsrId>> overlapping(const std::vector<AsrShape>& shapes,
                                             const std::vector<Closure>& closures) {
  std::map<AsrId, std::set<AsrId>> of;
  for (const AsrShape& shape : shapes) of[shape.id].insert(shape.id);
  for (const Closure& closure : closures) {
    if (closure.verdict != ClosureVerdict::accepted) continue;
    if (!of.contains(closure.from) || !of.contains(closure.to)) continue;
    of[closure.from].insert(closure.to);
    of[closure.to].insert(closure.from);
  }
  return of;
}

/// A visit's faces, told once for all that it lies on.
struct Seen {
  double cell_m = 0.0;
  std::vector<Face> faces;
};

/// The faces of all shapes in the frame of one.
LocalMap faces_around(const Pose2& building_from_map, const std::set<AsrId>& ids,
                      const std::map<AsrId, Seen>& seen_by, const Placement& placement) {
  LocalMap map(seen_by.at(*ids.begin()).cell_m);
  for (const AsrId id : ids) {
    const Pose2 map_from_asr = inverse(building_from_map) * placement.at(id);
    const PointTransform place(map_from_asr);
    const PointTransform turn({0.0, 0.0, map_from_asr.theta_rad});
    for (const Face& face : seen_by.at(id).faces) {
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
                const FeedBackOptions& options, int jobs) {
  auto found = results_of<std::vector<Face>>(shapes.size(), jobs, [&](std::size_t i) {
    return shapes[i].map.faces(options.min_face_hits);
  });
  std::map<AsrId, Seen> seen_by;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    seen_by[shapes[i].id] = {shapes[i].map.frame().cell_m, std::move(found[i])};
  }
  const auto around = overlapping(shapes, closures);
  const std::vector<std::pair<AsrId, std::set<AsrId>>> all(around.begin(), around.end());
  const SharedSource shared(source);
  auto matched = results_of<std::vector<Pose2>>(all.size(), jobs, [&](std::size_t i) {
    const auto& [id, ids] = all[i];
    return matched_path(shared.get(id, AsrDetail::readings),
                        faces_around(placement.at(id), ids, seen_by, placement), options);
  });
  Paths paths;
  for (std::size_t i = 0; i < all.size(); ++i) paths[all[i].first] = std::move(matched[i]);
  return paths;
}

}  // namespace roomatlas
