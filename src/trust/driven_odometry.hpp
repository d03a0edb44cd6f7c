// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "roomatlas/asr/asr.hpp"

namespace roomatlas {

/// How odometry's motion differs from the map's, over stretches of about a metre inside of visits.
class OdometryUse {
 public:
  /// @param path of one visit
  void add(const std::vector<PathSample>& path);

  struct Differences {
    double heading_rad_per_m = 0.0;  ///< root mean square, its steady part left out
    double drift_rad_per_m = 0.0;    ///< that part: positive where the map turns farther left
    double length_share = 0.0;       ///< root mean square, the steady part included
  };
  [[nodiscard]] Differences differences() const;
  [[nodiscard]] double path_m() const { return path_m_; }

 private:
  double path_m_ = 0.0;
  double stretches_ = 0.0;
  double heading_rad_ = 0.0;
  double heading_rad2_ = 0.0;
  double length2_ = 0.0;
};

}  // namespace roomatlas
