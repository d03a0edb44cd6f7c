// SPDX-License-Identifier: GPL-3.0-or-later
#include "sonar_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "line_sums.hpp"
#include "roomatlas/core/for_each_index.hpp"
#include "sonar_votes.hpp"
#include "straight_runs.hpp"

namespace roomatlas {
namespace {

constexpr std::size_t kFewest = 100;   // echoes that may have a direction
constexpr double kBand_m = 0.05;       // off a wall's line
constexpr double kLong_m = 2.0;        // such faces explain echoes before shorter ones do
constexpr double kWingFace_m = 1.5;    // corners make shorter faces in any direction ...
constexpr std::size_t kWingFaces = 3;  // ... a wing has so many ...
constexpr double kWingShare = 0.3;     // ... and this share of all walls so far
constexpr double kExplained_m = 0.15;  // an echo this near a face is its own
constexpr double kBeyondEnds_m = 0.1;
constexpr double kMostAside_rad = 45.0 * kPi / 180.0;  // of a cone's edge, that still hears
constexpr double kSlanted_m = 1.5;  // of a face along no direction of the building ...
constexpr double kApart_rad = 10.0 * kPi / 180.0;  // ... from any of which it is so far
constexpr double kOwn_m = 1.2;                     // of it that reflects ...
constexpr double kReflectedShare = 0.06;
constexpr double kNear_m = 0.3;  // ... farther than this from what is known
constexpr double kStep_m = 0.05;
constexpr std::array kAcross_m = {-0.05, 0.0, 0.05};
constexpr double kSlantedGap_m = 0.4;
constexpr double kSlantedStep_deg = 5.0;  // between directions that are tried first
constexpr int kRefinements = 3;

/// A face as places are compared with it.
struct FaceLine {
  Point2 normal;
  Point2 along;
  double normal_rad = 0.0;
  double offset_m = 0.0;
  double low_m = 0.0;
  double high_m = 0.0;

  explicit FaceLine(const WallFace& face)
      : normal(face.normal()),
        along(face.along()),
        normal_rad(face.normal_rad),
        offset_m(face.offset_m),
        low_m(face.low_m()),
        high_m(face.high_m()) {}

  [[nodiscard]] bool has(const Point2& at, double near_m) const {
    if (std::abs(at.dot(normal) - offset_m) >= near_m) return false;
    const double along_m = at.dot(along);
    return along_m > low_m - kBeyondEnds_m && along_m < high_m + kBeyondEnds_m;
  }
};

std::vector<FaceLine> lines_of(const std::vector<WallFace>& faces) {
  std::vector<FaceLine> lines;
  lines.reserve(faces.size());
  for (const WallFace& face : faces) lines.emplace_back(face);
  return lines;
}

/// Whether a face is what an echo heard: the nearest of it within the cone is as far away. That is
/// the foot of the perpendicular, or where the cone's edge meets the face.
bool explains(const FaceLine& face, const Echo& echo, double half_cone_rad) {
  const Point2 from = echo.building_from_beam.position();
  constexpr double kRounding_m = 1e-3;  // more than that of the places compared
  const double reach_m = echo.range_m + kExplained_m + kRounding_m;
  if (std::abs(from.dot(face.normal) - face.offset_m) > reach_m) return false;  // most are
  const double axis_rad = echo.building_from_beam.theta_rad;
  const double off_rad = wrap_angle(axis_rad + kPi - face.normal_rad);
  const double aside_rad = std::max(0.0, std::abs(off_rad) - half_cone_rad);
  if (aside_rad > kMostAside_rad) return false;
  const double along_m = from.dot(face.along);
  if (along_m < face.low_m - kBeyondEnds_m - reach_m ||
      along_m > face.high_m + kBeyondEnds_m + reach_m) {
    return false;
  }
  const double ray_rad = face.normal_rad + kPi + std::copysign(aside_rad, off_rad);
  return face.has(from + echo.range_m * direction(ray_rad), kExplained_m);
}

double total_support_m(const std::vector<WallFace>& faces) {
  double sum_m = 0.0;
  for (const WallFace& face : faces) sum_m += face.support_m();
  return sum_m;
}

/// Echoes that vote for faces until one is found that explains them.
class Voters {
 public:
  Voters(const BuildingEvidence& evidence, const WallFaceOptions& options, int jobs)
      : echoes_(evidence.echoes),
        half_cone_rad_(evidence.sonar_half_cone_rad),
        counts_(evidence.counts),
        options_(options),
        jobs_(jobs) {
    std::erase_if(echoes_, [](const Echo& echo) { return !echo.is_hit; });
  }

  [[nodiscard]] std::size_t size() const { return echoes_.size(); }

  [[nodiscard]] double best_direction_rad() const {
    return roomatlas::best_direction_rad(echoes_, half_cone_rad_, options_.sonar_range_m, jobs_);
  }

  /// Faces along a direction of the building.
  [[nodiscard]] std::vector<WallFace> along(double direction_rad, double min_support_m) const {
    std::vector<WallFace> faces;
    for (auto& of_quarter : results_of<std::vector<WallFace>>(4, jobs_, [&](std::size_t quarter) {
           const double normal_rad =
               wrap_angle(direction_rad + static_cast<double>(quarter) * kPi / 2.0);
           return looking_along(normal_rad, options_.max_gap_m, min_support_m);
         })) {
      for (WallFace& face : of_quarter) {
        face.is_regular = true;
        faces.push_back(std::move(face));
      }
    }
    return faces;
  }

  /// Faces along no direction of the building that look one way.
  /// @param known what edges of doors belong to: they are heard from all around, and vote for faces
  ///   that cross their wall
  [[nodiscard]] std::vector<WallFace> slanted(double normal_rad,
                                              const std::vector<FaceLine>& known) const {
    std::vector<WallFace> faces = looking_along(normal_rad, kSlantedGap_m, kSlanted_m);
    std::erase_if(faces, [&](const WallFace& face) { return own_m(face, known) < kOwn_m; });
    return faces;
  }

  /// @param directions_rad of the building, which slanted faces stay away from
  [[nodiscard]] std::optional<WallFace> longest_slanted(const std::vector<double>& directions_rad,
                                                        const std::vector<FaceLine>& known) const {
    const auto longest_of = [&](const std::vector<double>& normals_rad) {
      std::optional<WallFace> best;
      for (const auto& faces : results_of<std::vector<WallFace>>(
               normals_rad.size(), jobs_, [&](std::size_t i) -> std::vector<WallFace> {
                 const bool is_near = std::any_of(
                     directions_rad.begin(), directions_rad.end(), [&](double known_rad) {
                       return std::abs(wrap_quarter(normals_rad[i] - known_rad)) < kApart_rad;
                     });
                 return is_near ? std::vector<WallFace>() : slanted(normals_rad[i], known);
               })) {
        for (const WallFace& face : faces) {
          if (!best || face.support_m() > best->support_m()) best = face;
        }
      }
      return best;
    };
    std::vector<double> all_rad;
    for (double deg = -180.0; deg < 180.0; deg += kSlantedStep_deg) {
      all_rad.push_back(deg * kPi / 180.0);
    }
    std::optional<WallFace> best = longest_of(all_rad);
    for (int round = 0; best && round < kRefinements; ++round) {
      const WallFace coarse = *best;
      best = longest_of({fitted_normal_rad(coarse)});
      if (!best) return coarse;
    }
    return best;
  }

  /// Echoes that a face explains vote no more.
  void drop_explained(const std::vector<WallFace>& faces) {
    constexpr std::size_t kBlock = 4096;  // echoes: enough work to be handed out
    const std::vector<FaceLine> lines = lines_of(faces);
    std::vector<char> is_explained(echoes_.size());
    for_each_index((echoes_.size() + kBlock - 1) / kBlock, jobs_, [&](std::size_t block) {
      const std::size_t past = std::min(echoes_.size(), (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < past; ++i) {
        is_explained[i] = std::any_of(lines.begin(), lines.end(), [&](const FaceLine& face) {
          return explains(face, echoes_[i], half_cone_rad_);
        });
      }
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < echoes_.size(); ++i) {
      if (is_explained[i] == 0) echoes_[kept++] = echoes_[i];
    }
    echoes_.resize(kept);
  }

 private:
  /// Of the line through the feet of the perpendiculars, which turns as its walls do.
  [[nodiscard]] double fitted_normal_rad(const WallFace& face) const {
    const Point2 middle = face.at((face.low_m() + face.high_m()) / 2.0);
    const FaceLine line(face);
    LineSums feet;
    for (const SurfacePoint& vote :
         votes_for(face.normal_rad, echoes_, half_cone_rad_, options_.sonar_range_m)) {
      if (line.has(vote.at, kBand_m)) feet.add(vote.at - middle);
    }
    const double turn_rad = feet.line().direction_rad - (face.normal_rad + kPi / 2.0);
    return wrap_angle(face.normal_rad + std::remainder(turn_rad, kPi));
  }

  /// How much of a face reflects away from those that are known.
  [[nodiscard]] double own_m(const WallFace& face, const std::vector<FaceLine>& known) const {
    const Point2 normal = face.normal();
    double sum_m = 0.0;
    for (const Interval& seen : face.seen) {
      for (double along_m = seen.low_m; along_m < seen.high_m; along_m += kStep_m) {
        const Point2 at = face.at(along_m);
        const bool is_near = std::any_of(known.begin(), known.end(),
                                         [&](const FaceLine& one) { return one.has(at, kNear_m); });
        double most = 0.0;
        for (const double across_m : kAcross_m) {
          const Point2 beside = at + across_m * normal;
          most = std::max(most, counts_.at(counts_.frame().cell_of(beside)).reflected_share());
        }
        if (!is_near && most >= kReflectedShare) sum_m += kStep_m;
      }
    }
    return sum_m;
  }
  [[nodiscard]] std::vector<WallFace> looking_along(double normal_rad, double max_gap_m,
                                                    double min_support_m) const {
    const RunOptions runs{
        options_.bin_along_m, kBand_m, static_cast<double>(options_.min_hits), max_gap_m,
        min_support_m,        false};
    return straight_runs(votes_for(normal_rad, echoes_, half_cone_rad_, options_.sonar_range_m),
                         normal_rad, runs);
  }

  std::vector<Echo> echoes_;
  double half_cone_rad_;
  const ReflectionMap& counts_;
  const WallFaceOptions& options_;
  int jobs_;
};

/// The directions of the building that echoes follow, the main one first.
std::vector<double> directions_rad_of(Voters voters, const WallFaceOptions& options) {
  const auto all = static_cast<double>(voters.size());
  std::vector<double> directions_rad;
  double walls_m = 0.0;
  for (int round = 0; round <= options.max_wings && voters.size() >= kFewest; ++round) {
    const double direction_rad = voters.best_direction_rad();
    const std::vector<WallFace> found = voters.along(direction_rad, kWingFace_m);
    const auto before = static_cast<double>(voters.size());
    voters.drop_explained(found);
    const double votes = before - static_cast<double>(voters.size());
    const bool is_wing =
        found.size() >= kWingFaces && total_support_m(found) >= kWingShare * walls_m;
    if (round > 0 && (votes < options.wing_share * all || !is_wing)) break;
    walls_m += total_support_m(found);
    directions_rad.push_back(direction_rad);
  }
  return directions_rad;
}

/// Long faces that are not along the main direction.
std::vector<WallFace> long_aslant(const std::vector<double>& directions_rad, Voters voters) {
  const std::vector<WallFace> main = voters.along(directions_rad.front(), kLong_m);
  std::vector<FaceLine> known = lines_of(main);
  std::vector<WallFace> faces;
  const auto take = [&](const std::vector<WallFace>& found) {
    voters.drop_explained(found);
    for (const WallFace& face : found) known.emplace_back(face);
    faces.insert(faces.end(), found.begin(), found.end());
  };
  voters.drop_explained(main);
  for (std::size_t wing = 1; wing < directions_rad.size(); ++wing) {
    take(voters.along(directions_rad[wing], kLong_m));
  }
  while (const auto slanted = voters.longest_slanted(directions_rad, known)) {
    take({*slanted});
    take(voters.slanted(wrap_angle(slanted->normal_rad + kPi), known));  // the wall's other side
  }
  return faces;
}

}  // namespace

std::vector<WallFace> sonar_faces(const BuildingEvidence& evidence, const WallFaceOptions& options,
                                  int jobs) {
  Voters voters(evidence, options, jobs);
  const std::vector<double> directions_rad = directions_rad_of(voters, options);
  if (directions_rad.empty()) return {};
  std::vector<WallFace> faces = long_aslant(directions_rad, voters);
  voters.drop_explained(faces);
  for (const double direction_rad : directions_rad) {
    std::vector<WallFace> found = voters.along(direction_rad, options.min_wing_support_m);
    voters.drop_explained(found);
    std::move(found.begin(), found.end(), std::back_inserter(faces));
  }
  return faces;
}

}  // namespace roomatlas
