// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train sonar`, from 97 missions, 53 of them right, with 5110 visits.
#include "learnt_model.hpp"

namespace roomatlas {

const LearntModel& sonar_model() {
  static constexpr LearntTerm kRight[] = {
      {"clutter before walls", -5.477, 1.441, -0.572},
      {"contradiction of walls", -4.074, 0.9122, -0.2032},
      {"doubled walls", -2.37, 0.1673, -0.2481},
      {"echoes a reading", 1.909, 0.5213, 0.2981},
      {"hits in free space", -3.355, 0.6071, 0.01532},
      {"odometry's bias", -3.717, 1.054, 0.171},
      {"odometry's gain", -4.231, 0.9352, 0.002492},
      {"odometry's headings against the map's", -3.706, 0.5194, -0.4801},
      {"odometry's lengths against the map's", -3.969, 0.7193, -0.1257},
      {"odometry's steady drift", -3.71, 1.054, -0.07058},
      {"pairs of stretches", 1.102, 0.4011, -0.005345},
      {"path", 5.202, 0.7061, -0.08439},
      {"score of another winding", 0.2217, 0.3172, -0.1523},
      {"seen again", 0.869, 0.1029, 0.2586},
      {"slips repaired", 0.04706, 0.1871, -0.2491},
      {"stretches of wall a metre", 1.265, 0.5188, 0.1558},
      {"uncertainty of the scale", -5.379, 0.6136, 0.1358},
      {"undecided drives", -5.131, 1.352, -0.07339},
      {"unsure heading", -4.776, 1.251, -0.3658},
      {"visits", 3.779, 0.6793, 0.03918},
      {"wall heard again", 1.03, 0.4259, 0.05741},
      {"worst visit's hits in free space", -2.171, 0.6253, -0.07427},
  };
  static constexpr LearntTerm kPlace[] = {
      {"clutter before walls", -5.477, 1.441, 0.4192},
      {"contradiction of walls", -4.074, 0.9122, 0.1398},
      {"doubled walls", -2.37, 0.1673, 0.1983},
      {"echoes a reading", 1.909, 0.5213, -0.2009},
      {"hits in free space", -3.355, 0.6071, 0.1217},
      {"odometry's bias", -3.717, 1.054, -0.09512},
      {"odometry's gain", -4.231, 0.9352, -0.03081},
      {"odometry's headings against the map's", -3.706, 0.5194, 0.1085},
      {"odometry's lengths against the map's", -3.969, 0.7193, 0.09239},
      {"odometry's steady drift", -3.71, 1.054, 0.1023},
      {"pairs of stretches", 1.102, 0.4011, 0.1459},
      {"path", 5.202, 0.7061, 0.2294},
      {"score of another winding", 0.2217, 0.3172, 0.07909},
      {"seen again", 0.869, 0.1029, -0.1853},
      {"slips repaired", 0.04706, 0.1871, 0.05856},
      {"stretches of wall a metre", 1.265, 0.5188, -0.05547},
      {"uncertainty of the scale", -5.379, 0.6136, 0.01962},
      {"undecided drives", -5.131, 1.352, 0.07599},
      {"unsure heading", -4.776, 1.251, 0.2783},
      {"visits", 3.779, 0.6793, -0.06495},
      {"wall heard again", 1.03, 0.4259, 0.1161},
      {"worst visit's hits in free space", -2.171, 0.6253, 0.1263},
  };
  static constexpr LearntTerm kHeading[] = {
      {"clutter before walls", -5.477, 1.441, 0.2485},
      {"contradiction of walls", -4.074, 0.9122, 0.1465},
      {"doubled walls", -2.37, 0.1673, 0.07003},
      {"echoes a reading", 1.909, 0.5213, -0.1152},
      {"hits in free space", -3.355, 0.6071, 0.06277},
      {"odometry's bias", -3.717, 1.054, -0.152},
      {"odometry's gain", -4.231, 0.9352, -0.1484},
      {"odometry's headings against the map's", -3.706, 0.5194, 0.2336},
      {"odometry's lengths against the map's", -3.969, 0.7193, 0.08714},
      {"odometry's steady drift", -3.71, 1.054, 0.0277},
      {"pairs of stretches", 1.102, 0.4011, 0.04347},
      {"path", 5.202, 0.7061, 0.03826},
      {"score of another winding", 0.2217, 0.3172, 0.122},
      {"seen again", 0.869, 0.1029, 0.04495},
      {"slips repaired", 0.04706, 0.1871, 0.04982},
      {"stretches of wall a metre", 1.265, 0.5188, -0.07886},
      {"uncertainty of the scale", -5.379, 0.6136, -0.01337},
      {"undecided drives", -5.131, 1.352, 0.02051},
      {"unsure heading", -4.776, 1.251, 0.3266},
      {"visits", 3.779, 0.6793, -0.01149},
      {"wall heard again", 1.03, 0.4259, 0.05031},
      {"worst visit's hits in free space", -2.171, 0.6253, 0.06229},
  };
  static constexpr LearntTerm kScale[] = {
      {"clutter before walls", -5.477, 1.441, 0.4855},
      {"contradiction of walls", -4.074, 0.9122, 0.1413},
      {"doubled walls", -2.37, 0.1673, 0.0959},
      {"echoes a reading", 1.909, 0.5213, -0.1722},
      {"hits in free space", -3.355, 0.6071, 0.1581},
      {"odometry's bias", -3.717, 1.054, -0.09168},
      {"odometry's gain", -4.231, 0.9352, -0.02578},
      {"odometry's headings against the map's", -3.706, 0.5194, 0.1975},
      {"odometry's lengths against the map's", -3.969, 0.7193, 0.1289},
      {"odometry's steady drift", -3.71, 1.054, 0.1175},
      {"pairs of stretches", 1.102, 0.4011, 0.1318},
      {"path", 5.202, 0.7061, 0.005961},
      {"score of another winding", 0.2217, 0.3172, 0.09389},
      {"seen again", 0.869, 0.1029, -0.1257},
      {"slips repaired", 0.04706, 0.1871, 0.00773},
      {"stretches of wall a metre", 1.265, 0.5188, -0.04806},
      {"uncertainty of the scale", -5.379, 0.6136, 0.03002},
      {"undecided drives", -5.131, 1.352, 0.0335},
      {"unsure heading", -4.776, 1.251, 0.2956},
      {"visits", 3.779, 0.6793, -0.1833},
      {"wall heard again", 1.03, 0.4259, 0.04907},
      {"worst visit's hits in free space", -2.171, 0.6253, 0.1535},
  };
  static constexpr LearntTerm kVisitRight[] = {
      {"doubled walls", -2.846, 0.7055, -0.02284},
      {"hits in free space", -4.136, 1.56, -0.2252},
      {"seen again", 0.6144, 0.18, 0.1427},
      {"map", 0.11, 1.699, 1.048},
  };
  static constexpr LearntTerm kVisitPlace[] = {
      {"doubled walls", -2.846, 0.7055, 0.07825},
      {"hits in free space", -4.136, 1.56, 0.1211},
      {"seen again", 0.6144, 0.18, -0.09312},
      {"map", 0.11, 1.699, -0.887},
  };
  static const LearntModel kModel{{0.09749, kRight}, {0.04528, kPlace},     {2.099, kHeading},
                                  {-3.218, kScale},  {0.9871, kVisitRight}, {-0.5043, kVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
