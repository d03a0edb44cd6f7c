// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train laser`, from 81 missions, 51 of them right, with 4180 visits.
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

constexpr LearntTerm kRight[] = {
    {"contradiction in matches", -2.201, 0.6023, -0.2908},
    {"doubled walls", -3.363, 0.6378, -0.3816},
    {"echoes a reading", 5.398, 1.169, 0.2495},
    {"hits in free space", -4.437, 1.439, -0.4803},
    {"loops a visit", 1.35, 0.4583, 0.4212},
    {"matches accepted", 0.6316, 0.2154, 0.4438},
    {"odometry's headings against the map's", -3.301, 0.6142, -0.7859},
    {"odometry's lengths against the map's", -2.436, 0.8044, -0.1318},
    {"odometry's steady drift", -3.812, 0.9798, -0.7549},
    {"passages in which the robot was lost", 0.1155, 0.4717, -0.4981},
    {"path", 5.192, 0.8513, -0.5281},
    {"place of a visit", -3.322, 1.39, -0.7887},
    {"place of the loosest visit", -2.576, 1.354, -0.729},
    {"seen again", 0.9709, 0.03632, -0.2906},
    {"strain of loops", -0.836, 0.923, -0.9335},
    {"visits", 3.61, 0.9055, -0.4457},
    {"visits on one passage", 0.059, 0.1458, 0.1781},
    {"worst visit's hits in free space", -2.982, 1.518, -0.6291},
};

constexpr LearntTerm kPlace[] = {
    {"contradiction in matches", -2.201, 0.6023, 0.1458},
    {"doubled walls", -3.363, 0.6378, 0.312},
    {"echoes a reading", 5.398, 1.169, -0.243},
    {"hits in free space", -4.437, 1.439, 0.2579},
    {"loops a visit", 1.35, 0.4583, -0.2485},
    {"matches accepted", 0.6316, 0.2154, -0.1041},
    {"odometry's headings against the map's", -3.301, 0.6142, 0.08524},
    {"odometry's lengths against the map's", -2.436, 0.8044, 0.1545},
    {"odometry's steady drift", -3.812, 0.9798, 0.1611},
    {"passages in which the robot was lost", 0.1155, 0.4717, 0.148},
    {"path", 5.192, 0.8513, 0.1808},
    {"place of a visit", -3.322, 1.39, 0.4349},
    {"place of the loosest visit", -2.576, 1.354, 0.3869},
    {"seen again", 0.9709, 0.03632, 0.1198},
    {"strain of loops", -0.836, 0.923, 0.2942},
    {"visits", 3.61, 0.9055, 0.03644},
    {"visits on one passage", 0.059, 0.1458, 0.07632},
    {"worst visit's hits in free space", -2.982, 1.518, 0.155},
};

constexpr LearntTerm kHeading[] = {
    {"contradiction in matches", -2.201, 0.6023, 0.0202},
    {"doubled walls", -3.363, 0.6378, 0.6274},
    {"echoes a reading", 5.398, 1.169, -0.2269},
    {"hits in free space", -4.437, 1.439, -0.03771},
    {"loops a visit", 1.35, 0.4583, -0.1016},
    {"matches accepted", 0.6316, 0.2154, -0.339},
    {"odometry's headings against the map's", -3.301, 0.6142, 0.2331},
    {"odometry's lengths against the map's", -2.436, 0.8044, 0.2238},
    {"odometry's steady drift", -3.812, 0.9798, -0.04098},
    {"passages in which the robot was lost", 0.1155, 0.4717, 0.1417},
    {"path", 5.192, 0.8513, -0.001862},
    {"place of a visit", -3.322, 1.39, 0.3678},
    {"place of the loosest visit", -2.576, 1.354, 0.1823},
    {"seen again", 0.9709, 0.03632, 0.2132},
    {"strain of loops", -0.836, 0.923, 0.3877},
    {"visits", 3.61, 0.9055, 0.09101},
    {"visits on one passage", 0.059, 0.1458, 0.1165},
    {"worst visit's hits in free space", -2.982, 1.518, 0.08969},
};

constexpr LearntTerm kScale[] = {
    {"contradiction in matches", -2.201, 0.6023, 0.2391},
    {"doubled walls", -3.363, 0.6378, 0.3893},
    {"echoes a reading", 5.398, 1.169, -0.1888},
    {"hits in free space", -4.437, 1.439, 0.2653},
    {"loops a visit", 1.35, 0.4583, -0.1598},
    {"matches accepted", 0.6316, 0.2154, -0.1265},
    {"odometry's headings against the map's", -3.301, 0.6142, 0.06318},
    {"odometry's lengths against the map's", -2.436, 0.8044, 0.1466},
    {"odometry's steady drift", -3.812, 0.9798, 0.1646},
    {"passages in which the robot was lost", 0.1155, 0.4717, 0.1647},
    {"path", 5.192, 0.8513, -0.003003},
    {"place of a visit", -3.322, 1.39, 0.3327},
    {"place of the loosest visit", -2.576, 1.354, 0.2738},
    {"seen again", 0.9709, 0.03632, 0.1697},
    {"strain of loops", -0.836, 0.923, 0.2757},
    {"visits", 3.61, 0.9055, -0.1298},
    {"visits on one passage", 0.059, 0.1458, 0.1486},
    {"worst visit's hits in free space", -2.982, 1.518, 0.08799},
};

constexpr LearntTerm kVisitRight[] = {
    {"doubled walls", -3.366, 0.5912, -0.203}, {"hits in free space", -4.86, 1.595, -0.3009},
    {"loops", 1.953, 0.6903, 0.3199},          {"place", -3.603, 1.594, -0.6195},
    {"seen again", 0.9234, 0.06301, 0.07637},  {"map", 0.6095, 4.223, 1.761},
};

constexpr LearntTerm kVisitPlace[] = {
    {"doubled walls", -3.366, 0.5912, 0.02611}, {"hits in free space", -4.86, 1.595, 0.2496},
    {"loops", 1.953, 0.6903, -0.3228},          {"place", -3.603, 1.594, 0.3604},
    {"seen again", 0.9234, 0.06301, -0.1049},   {"map", 0.6095, 4.223, -1.31},
};

}  // namespace

const LearntModel& laser_model() {
  static const LearntModel kModel{{1.428, kRight},  {-1.693, kPlace},    {1.24, kHeading},
                                  {-4.338, kScale}, {2.75, kVisitRight}, {-1.972, kVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
