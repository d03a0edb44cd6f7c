// SPDX-License-Identifier: GPL-3.0-or-later
// Missions that hold each other, while more are looked for.
#pragma once

#include <map>
#include <vector>

#include "roomatlas/join/join_missions.hpp"
#include "visits_near.hpp"

namespace roomatlas {

/// What is joined so far, in one frame. Missions, options and workers must outlive it.
class JoinedComponent {
 public:
  JoinedComponent(const MissionMap& base, const JoinOptions& options, const Workers& workers);

  [[nodiscard]] std::size_t missions() const { return missions_.size(); }
  [[nodiscard]] double known_m2() const { return index_.seen().known_m2(); }
  [[nodiscard]] const Placement& placement() const { return placement_; }
  [[nodiscard]] const std::vector<Closure>& closures() const { return closures_; }

  /// Where a mission lies in it, by its walls, and where these leave it open by its readings.
  [[nodiscard]] MissionSearch search(const MissionMap& mission, const Progress& progress) const;
  void join(const MissionMap& mission, const MissionPlace& place);

  /// Once all are placed: every visit is matched again with those of other missions that came to
  /// lie near, farther around, and what was found before is forgotten.
  void match_again(double loss_width = 1.0);

  /// Where matches that readings bear out were thrown out, a mission may lie where it bent to, held
  /// there by false matches of what looks alike. All is matched again, under losses that are wide
  /// first and narrow to what they are (graduated non-convexity, Blake and Zisserman 1987).
  /// @returns whether the matches that hold have more in common since; else all is as it was
  bool straighten();

 private:
  struct Pair {
    const AsrShape* first = nullptr;
    const AsrShape* second = nullptr;
    double apart_m = 0.0;
  };
  struct Known {
    const AsrShape* shape = nullptr;
    SensorKind sensor = SensorKind::laser;
  };

  /// Whether readings put the mission where its walls do. By one for all, as solving is.
  [[nodiscard]] bool is_borne_out(const MissionMap& mission,
                                  const std::vector<MissionPlace>& places) const;
  /// By one for all: then no rounding of another machine moves anything.
  void solve(double loss_width = 1.0);
  /// Moves the mission against what is joined; where that cannot be without a contradiction, all is
  /// as it was.
  bool moved_alone(const MissionMap& mission, const std::vector<Closure>& found);
  void take_in(const MissionMap& mission);
  /// Each visit with the nearest ones of other missions that are joined already.
  /// @param visits where these are
  [[nodiscard]] std::vector<Closure> matched(const MissionMap& mission, const VisitsNear& visits,
                                             const SearchWindow& window) const;
  [[nodiscard]] std::vector<Pair> nearest_to(const AsrShape& shape, const VisitsNear& visits) const;
  [[nodiscard]] Closure tried(const Pair& pair, SensorKind sensor,
                              const SearchWindow& window) const;
  /// Whether solving threw out a match that readings do not contradict. Whatever the sensors, it
  /// has the points that one of lasers must have: few of a sonar are no reason to look again.
  [[nodiscard]] bool throws_out() const;

  const JoinOptions& options_;
  const Workers& workers_;
  BuildingIndex index_;
  VisitsNear near_;
  std::map<AsrId, Known> shapes_;
  std::vector<const MissionMap*> missions_;
  Placement placement_;
  std::vector<Closure> closures_;
  double visits_since_ = 0.0;  ///< that joined since all were solved together
};

}  // namespace roomatlas
