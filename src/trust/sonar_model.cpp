// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train sonar`, from 65 missions, 22 of them right, with 4074 visits.
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

constexpr LearntTerm kRight[] = {
    {"contradiction of walls", -3.814, 1.158, -0.02665},
    {"doubled walls", -2.373, 0.2342, 0.0122},
    {"echoes a reading", 1.963, 0.5727, 0.3927},
    {"hits in free space", -3.362, 0.8259, 0.101},
    {"odometry's bias", -4.085, 1.509, 0.1972},
    {"odometry's gain", -4.381, 1.071, -0.2882},
    {"odometry's headings against the map's", -3.698, 0.6035, -0.02792},
    {"odometry's lengths against the map's", -4.375, 0.7831, -0.6025},
    {"odometry's steady drift", -3.944, 1.271, 0.1871},
    {"pairs of stretches", 1.112, 0.4245, 0.01837},
    {"path", 5.356, 0.6342, -0.3934},
    {"score of another winding", 0.234, 0.3602, -0.1091},
    {"seen again", 0.8812, 0.1059, 0.03226},
    {"slips repaired", 0.01066, 0.08531, -0.02584},
    {"stretches of wall a metre", 1.334, 0.5911, 0.4795},
    {"undecided drives", -5.147, 1.558, 0.08294},
    {"unsure heading", -4.879, 1.027, -0.1433},
    {"visits", 3.927, 0.6592, -0.05665},
    {"wall heard again", 1.096, 0.4364, -0.0315},
    {"worst visit's hits in free space", -2.174, 0.8096, 0.03358},
};

constexpr LearntTerm kPlace[] = {
    {"contradiction of walls", -3.814, 1.158, 0.9263},
    {"doubled walls", -2.373, 0.2342, -0.4662},
    {"echoes a reading", 1.963, 0.5727, -0.3681},
    {"hits in free space", -3.362, 0.8259, 0.03389},
    {"odometry's bias", -4.085, 1.509, -0.6104},
    {"odometry's gain", -4.381, 1.071, -0.2054},
    {"odometry's headings against the map's", -3.698, 0.6035, -0.01472},
    {"odometry's lengths against the map's", -4.375, 0.7831, 0.4652},
    {"odometry's steady drift", -3.944, 1.271, 0.2438},
    {"pairs of stretches", 1.112, 0.4245, -0.3511},
    {"path", 5.356, 0.6342, 1.027},
    {"score of another winding", 0.234, 0.3602, 0.1939},
    {"seen again", 0.8812, 0.1059, 0.1768},
    {"slips repaired", 0.01066, 0.08531, -0.06154},
    {"stretches of wall a metre", 1.334, 0.5911, -0.738},
    {"undecided drives", -5.147, 1.558, -0.1837},
    {"unsure heading", -4.879, 1.027, -0.06486},
    {"visits", 3.927, 0.6592, -0.5297},
    {"wall heard again", 1.096, 0.4364, 0.8227},
    {"worst visit's hits in free space", -2.174, 0.8096, 0.1458},
};

constexpr LearntTerm kHeading[] = {
    {"contradiction of walls", -3.814, 1.158, 0.5662},
    {"doubled walls", -2.373, 0.2342, 0.05973},
    {"echoes a reading", 1.963, 0.5727, -0.2292},
    {"hits in free space", -3.362, 0.8259, 0.07281},
    {"odometry's bias", -4.085, 1.509, -0.2237},
    {"odometry's gain", -4.381, 1.071, -0.1443},
    {"odometry's headings against the map's", -3.698, 0.6035, 0.09032},
    {"odometry's lengths against the map's", -4.375, 0.7831, 0.1323},
    {"odometry's steady drift", -3.944, 1.271, -0.08512},
    {"pairs of stretches", 1.112, 0.4245, -0.02699},
    {"path", 5.356, 0.6342, 0.1597},
    {"score of another winding", 0.234, 0.3602, 0.1251},
    {"seen again", 0.8812, 0.1059, -0.02838},
    {"slips repaired", 0.01066, 0.08531, -0.003513},
    {"stretches of wall a metre", 1.334, 0.5911, -0.2124},
    {"undecided drives", -5.147, 1.558, 0.08116},
    {"unsure heading", -4.879, 1.027, 0.1271},
    {"visits", 3.927, 0.6592, 0.06808},
    {"wall heard again", 1.096, 0.4364, 0.1315},
    {"worst visit's hits in free space", -2.174, 0.8096, 0.1123},
};

constexpr LearntTerm kScale[] = {
    {"contradiction of walls", -3.814, 1.158, 0.854},
    {"doubled walls", -2.373, 0.2342, -0.3213},
    {"echoes a reading", 1.963, 0.5727, -0.3735},
    {"hits in free space", -3.362, 0.8259, 0.04468},
    {"odometry's bias", -4.085, 1.509, -0.307},
    {"odometry's gain", -4.381, 1.071, -0.1589},
    {"odometry's headings against the map's", -3.698, 0.6035, 0.02936},
    {"odometry's lengths against the map's", -4.375, 0.7831, 0.5159},
    {"odometry's steady drift", -3.944, 1.271, -0.1256},
    {"pairs of stretches", 1.112, 0.4245, -0.0629},
    {"path", 5.356, 0.6342, 0.3709},
    {"score of another winding", 0.234, 0.3602, 0.1169},
    {"seen again", 0.8812, 0.1059, 0.2671},
    {"slips repaired", 0.01066, 0.08531, -0.1237},
    {"stretches of wall a metre", 1.334, 0.5911, -0.7},
    {"undecided drives", -5.147, 1.558, -0.1305},
    {"unsure heading", -4.879, 1.027, -0.08557},
    {"visits", 3.927, 0.6592, -0.2988},
    {"wall heard again", 1.096, 0.4364, 0.4754},
    {"worst visit's hits in free space", -2.174, 0.8096, -0.0295},
};

constexpr LearntTerm kVisitRight[] = {
    {"doubled walls", -2.801, 0.6154, -0.1038},
    {"hits in free space", -4.156, 1.536, -0.09906},
    {"loops", 0.0, 1e-06, 0.0},
    {"place", -6.908, 1e-06, 4.401e-16},
    {"seen again", 0.6349, 0.1795, 0.1533},
    {"map", -1.067, 1.217, 0.5711},
};

constexpr LearntTerm kVisitPlace[] = {
    {"doubled walls", -2.801, 0.6154, 0.1927},
    {"hits in free space", -4.156, 1.536, 0.1627},
    {"loops", 0.0, 1e-06, 0.0},
    {"place", -6.908, 1e-06, -4.305e-15},
    {"seen again", 0.6349, 0.1795, -0.2466},
    {"map", -1.067, 1.217, -0.6071},
};

}  // namespace

const LearntModel& sonar_model() {
  static const LearntModel kModel{{-0.9746, kRight}, {0.4876, kPlace},      {2.888, kHeading},
                                  {-2.616, kScale},  {0.1322, kVisitRight}, {0.9774, kVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
