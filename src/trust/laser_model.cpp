// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train laser`, from 67 missions, 41 of them right, with 3592 visits.
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

constexpr LearntTerm kRight[] = {
    {"contradiction in matches", -2.219, 0.6231, -0.0843},
    {"doubled walls", -3.347, 0.6744, -0.2746},
    {"echoes a reading", 5.426, 1.202, 0.3194},
    {"hits in free space", -4.364, 1.475, -0.4413},
    {"loops a visit", 1.336, 0.4521, 0.364},
    {"matches accepted", 0.6232, 0.2293, 0.6769},
    {"odometry's headings against the map's", -3.309, 0.6611, -0.8804},
    {"odometry's lengths against the map's", -2.466, 0.8023, -0.03107},
    {"odometry's steady drift", -3.872, 1.028, -0.9048},
    {"passages in which the robot was lost", 0.1396, 0.5154, -0.4233},
    {"path", 5.236, 0.8317, -0.6504},
    {"place of a visit", -3.217, 1.352, -0.7702},
    {"place of the loosest visit", -2.478, 1.315, -0.7194},
    {"seen again", 0.971, 0.03614, -0.477},
    {"strain of loops", -0.784, 0.9053, -1.09},
    {"visits", 3.655, 0.9035, -0.5652},
    {"visits on one passage", 0.0647, 0.1509, 0.2521},
    {"worst visit's hits in free space", -2.891, 1.51, -0.6941},
};

constexpr LearntTerm kPlace[] = {
    {"contradiction in matches", -2.219, 0.6231, 0.1235},
    {"doubled walls", -3.347, 0.6744, 0.3035},
    {"echoes a reading", 5.426, 1.202, -0.2385},
    {"hits in free space", -4.364, 1.475, 0.2718},
    {"loops a visit", 1.336, 0.4521, -0.2418},
    {"matches accepted", 0.6232, 0.2293, -0.1225},
    {"odometry's headings against the map's", -3.309, 0.6611, 0.08603},
    {"odometry's lengths against the map's", -2.466, 0.8023, 0.1409},
    {"odometry's steady drift", -3.872, 1.028, 0.1532},
    {"passages in which the robot was lost", 0.1396, 0.5154, 0.1563},
    {"path", 5.236, 0.8317, 0.1945},
    {"place of a visit", -3.217, 1.352, 0.4144},
    {"place of the loosest visit", -2.478, 1.315, 0.3648},
    {"seen again", 0.971, 0.03614, 0.0983},
    {"strain of loops", -0.784, 0.9053, 0.2872},
    {"visits", 3.655, 0.9035, 0.05906},
    {"visits on one passage", 0.0647, 0.1509, 0.08416},
    {"worst visit's hits in free space", -2.891, 1.51, 0.2025},
};

constexpr LearntTerm kHeading[] = {
    {"contradiction in matches", -2.219, 0.6231, -0.003673},
    {"doubled walls", -3.347, 0.6744, 0.6063},
    {"echoes a reading", 5.426, 1.202, -0.1872},
    {"hits in free space", -4.364, 1.475, 0.007137},
    {"loops a visit", 1.336, 0.4521, -0.07051},
    {"matches accepted", 0.6232, 0.2293, -0.3995},
    {"odometry's headings against the map's", -3.309, 0.6611, 0.2821},
    {"odometry's lengths against the map's", -2.466, 0.8023, 0.1788},
    {"odometry's steady drift", -3.872, 1.028, -0.05052},
    {"passages in which the robot was lost", 0.1396, 0.5154, 0.1366},
    {"path", 5.236, 0.8317, -0.05762},
    {"place of a visit", -3.217, 1.352, 0.3633},
    {"place of the loosest visit", -2.478, 1.315, 0.1652},
    {"seen again", 0.971, 0.03614, 0.2329},
    {"strain of loops", -0.784, 0.9053, 0.4022},
    {"visits", 3.655, 0.9035, 0.1286},
    {"visits on one passage", 0.0647, 0.1509, 0.08197},
    {"worst visit's hits in free space", -2.891, 1.51, 0.1627},
};

constexpr LearntTerm kScale[] = {
    {"contradiction in matches", -2.219, 0.6231, 0.1141},
    {"doubled walls", -3.347, 0.6744, 0.279},
    {"echoes a reading", 5.426, 1.202, -0.1557},
    {"hits in free space", -4.364, 1.475, 0.226},
    {"loops a visit", 1.336, 0.4521, -0.1253},
    {"matches accepted", 0.6232, 0.2293, -0.1435},
    {"odometry's headings against the map's", -3.309, 0.6611, 0.08516},
    {"odometry's lengths against the map's", -2.466, 0.8023, 0.1183},
    {"odometry's steady drift", -3.872, 1.028, 0.1087},
    {"passages in which the robot was lost", 0.1396, 0.5154, 0.1086},
    {"path", 5.236, 0.8317, 0.01708},
    {"place of a visit", -3.217, 1.352, 0.2484},
    {"place of the loosest visit", -2.478, 1.315, 0.2266},
    {"seen again", 0.971, 0.03614, 0.03203},
    {"strain of loops", -0.784, 0.9053, 0.2217},
    {"visits", 3.655, 0.9035, -0.03097},
    {"visits on one passage", 0.0647, 0.1509, 0.1625},
    {"worst visit's hits in free space", -2.891, 1.51, 0.1623},
};

constexpr LearntTerm kVisitRight[] = {
    {"doubled walls", -3.366, 0.6085, -0.3397}, {"hits in free space", -4.85, 1.618, -0.3317},
    {"loops", 1.913, 0.6814, 0.2924},           {"place", -3.537, 1.567, -0.6283},
    {"seen again", 0.9229, 0.06309, 0.0533},    {"map", 0.1927, 4.513, 1.611},
};

constexpr LearntTerm kVisitPlace[] = {
    {"doubled walls", -3.366, 0.6085, 0.1335}, {"hits in free space", -4.85, 1.618, 0.2673},
    {"loops", 1.913, 0.6814, -0.3225},         {"place", -3.537, 1.567, 0.445},
    {"seen again", 0.9229, 0.06309, -0.1163},  {"map", 0.1927, 4.513, -1.183},
};

}  // namespace

const LearntModel& laser_model() {
  static const LearntModel kModel{{1.032, kRight},  {-1.644, kPlace},     {1.373, kHeading},
                                  {-4.207, kScale}, {2.671, kVisitRight}, {-1.722, kVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
