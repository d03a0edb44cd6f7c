// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train sonar`, from 76 missions, 27 of them right, with 4635 visits.
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

constexpr LearntTerm kRight[] = {
    {"contradiction of walls", -3.772, 1.154, -0.0737},
    {"doubled walls", -2.372, 0.234, 0.1129},
    {"echoes a reading", 1.949, 0.5708, 0.5029},
    {"hits in free space", -3.351, 0.8015, 0.1677},
    {"odometry's bias", -4.058, 1.491, 0.2498},
    {"odometry's gain", -4.426, 1.071, -0.2941},
    {"odometry's headings against the map's", -3.72, 0.5915, 0.02499},
    {"odometry's lengths against the map's", -4.401, 0.8479, -0.8277},
    {"odometry's steady drift", -3.935, 1.285, 0.1727},
    {"pairs of stretches", 1.092, 0.426, 0.02934},
    {"path", 5.327, 0.6205, -0.397},
    {"score of another winding", 0.2448, 0.3558, -0.1106},
    {"seen again", 0.8831, 0.1053, -0.0804},
    {"slips repaired", 0.00912, 0.07898, -0.04377},
    {"stretches of wall a metre", 1.316, 0.5858, 0.6131},
    {"undecided drives", -5.146, 1.582, 0.164},
    {"unsure heading", -4.84, 1.051, -0.2394},
    {"visits", 3.907, 0.6476, 0.1622},
    {"wall heard again", 1.082, 0.4365, -0.2328},
    {"worst visit's hits in free space", -2.17, 0.7779, -0.05648},
};

constexpr LearntTerm kPlace[] = {
    {"contradiction of walls", -3.772, 1.154, 0.8282},
    {"doubled walls", -2.372, 0.234, -0.5088},
    {"echoes a reading", 1.949, 0.5708, 0.08679},
    {"hits in free space", -3.351, 0.8015, 0.03012},
    {"odometry's bias", -4.058, 1.491, -0.8938},
    {"odometry's gain", -4.426, 1.071, -0.2432},
    {"odometry's headings against the map's", -3.72, 0.5915, 0.06036},
    {"odometry's lengths against the map's", -4.401, 0.8479, 0.569},
    {"odometry's steady drift", -3.935, 1.285, 0.5696},
    {"pairs of stretches", 1.092, 0.426, -0.6222},
    {"path", 5.327, 0.6205, 1.152},
    {"score of another winding", 0.2448, 0.3558, 0.2631},
    {"seen again", 0.8831, 0.1053, 0.151},
    {"slips repaired", 0.00912, 0.07898, -0.03381},
    {"stretches of wall a metre", 1.316, 0.5858, -1.107},
    {"undecided drives", -5.146, 1.582, -0.1907},
    {"unsure heading", -4.84, 1.051, -0.06842},
    {"visits", 3.907, 0.6476, -0.7926},
    {"wall heard again", 1.082, 0.4365, 1.05},
    {"worst visit's hits in free space", -2.17, 0.7779, 0.2462},
};

constexpr LearntTerm kHeading[] = {
    {"contradiction of walls", -3.772, 1.154, 0.3825},
    {"doubled walls", -2.372, 0.234, 0.09836},
    {"echoes a reading", 1.949, 0.5708, -0.16},
    {"hits in free space", -3.351, 0.8015, 0.1108},
    {"odometry's bias", -4.058, 1.491, -0.1824},
    {"odometry's gain", -4.426, 1.071, -0.09585},
    {"odometry's headings against the map's", -3.72, 0.5915, 0.05406},
    {"odometry's lengths against the map's", -4.401, 0.8479, 0.1644},
    {"odometry's steady drift", -3.935, 1.285, -0.1246},
    {"pairs of stretches", 1.092, 0.426, -0.03335},
    {"path", 5.327, 0.6205, 0.08018},
    {"score of another winding", 0.2448, 0.3558, 0.1545},
    {"seen again", 0.8831, 0.1053, -0.01544},
    {"slips repaired", 0.00912, 0.07898, 0.02895},
    {"stretches of wall a metre", 1.316, 0.5858, -0.1579},
    {"undecided drives", -5.146, 1.582, 0.06649},
    {"unsure heading", -4.84, 1.051, 0.1106},
    {"visits", 3.907, 0.6476, 0.009151},
    {"wall heard again", 1.082, 0.4365, 0.04765},
    {"worst visit's hits in free space", -2.17, 0.7779, 0.105},
};

constexpr LearntTerm kScale[] = {
    {"contradiction of walls", -3.772, 1.154, 0.7132},
    {"doubled walls", -2.372, 0.234, -0.2618},
    {"echoes a reading", 1.949, 0.5708, -0.2297},
    {"hits in free space", -3.351, 0.8015, -0.04422},
    {"odometry's bias", -4.058, 1.491, -0.3525},
    {"odometry's gain", -4.426, 1.071, -0.1795},
    {"odometry's headings against the map's", -3.72, 0.5915, 0.008108},
    {"odometry's lengths against the map's", -4.401, 0.8479, 0.5741},
    {"odometry's steady drift", -3.935, 1.285, -0.07553},
    {"pairs of stretches", 1.092, 0.426, -0.1774},
    {"path", 5.327, 0.6205, 0.3395},
    {"score of another winding", 0.2448, 0.3558, 0.1322},
    {"seen again", 0.8831, 0.1053, 0.2935},
    {"slips repaired", 0.00912, 0.07898, -0.04997},
    {"stretches of wall a metre", 1.316, 0.5858, -0.6859},
    {"undecided drives", -5.146, 1.582, -0.164},
    {"unsure heading", -4.84, 1.051, -0.01633},
    {"visits", 3.907, 0.6476, -0.4175},
    {"wall heard again", 1.082, 0.4365, 0.4707},
    {"worst visit's hits in free space", -2.17, 0.7779, 0.07001},
};

constexpr LearntTerm kVisitRight[] = {
    {"doubled walls", -2.798, 0.6341, -0.1239},
    {"hits in free space", -4.118, 1.538, -0.07532},
    {"loops", 0.0, 1e-06, 0.0},
    {"place", -6.908, 1e-06, 8.996e-16},
    {"seen again", 0.631, 0.1782, 0.2094},
    {"map", -0.9734, 1.365, 0.622},
};

constexpr LearntTerm kVisitPlace[] = {
    {"doubled walls", -2.798, 0.6341, 0.2527},
    {"hits in free space", -4.118, 1.538, 0.118},
    {"loops", 0.0, 1e-06, 0.0},
    {"place", -6.908, 1e-06, -7.531e-15},
    {"seen again", 0.631, 0.1782, -0.2899},
    {"map", -0.9734, 1.365, -0.6493},
};

}  // namespace

const LearntModel& sonar_model() {
  static const LearntModel kModel{{-0.8947, kRight}, {0.4905, kPlace},      {3.015, kHeading},
                                  {-2.793, kScale},  {0.1765, kVisitRight}, {0.8769, kVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
