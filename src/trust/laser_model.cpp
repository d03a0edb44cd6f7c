// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train laser`, from 227 missions, 166 of them right, with 10860 visits.
// Bars: printed by `bench_trust bars`, from 126 missions with 6219 visits.
#include "learnt_model.hpp"

namespace roomatlas {
namespace {

static constexpr LearntTerm kLaserRight[] = {
    {"contradiction in matches", -2.214, 0.639, -0.1668},
    {"doubled walls", -3.424, 0.5713, -0.6455},
    {"echoes a reading", 5.363, 1.167, -0.2282},
    {"hits in free space", -4.665, 1.385, -0.05437},
    {"loops a visit", 1.383, 0.4549, 0.3757},
    {"matches accepted", 0.618, 0.2082, 0.4852},
    {"odometry's headings against the map's", -3.285, 0.5606, -0.4709},
    {"odometry's lengths against the map's", -2.407, 0.7082, -0.123},
    {"odometry's steady drift", -3.777, 0.9974, -0.4212},
    {"passages in which the robot was lost", 0.07728, 0.3526, -0.4013},
    {"path", 5.108, 0.8768, -0.4096},
    {"place of a visit", -3.49, 1.364, -0.9563},
    {"place of the loosest visit", -2.75, 1.351, -0.8616},
    {"seen again", 0.9679, 0.05268, -0.05484},
    {"strain of loops", -0.9129, 0.9004, -0.7328},
    {"visits", 3.547, 0.9147, -0.1737},
    {"visits on one passage", 0.04916, 0.1264, 0.1853},
    {"worst visit's hits in free space", -3.226, 1.424, -0.6466},
};
static constexpr LearntTerm kLaserPlace[] = {
    {"contradiction in matches", -2.214, 0.639, -0.2129},
    {"doubled walls", -3.424, 0.5713, 0.1203},
    {"echoes a reading", 5.363, 1.167, -0.1223},
    {"hits in free space", -4.665, 1.385, -0.109},
    {"loops a visit", 1.383, 0.4549, -0.2573},
    {"matches accepted", 0.618, 0.2082, -0.007948},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.03943},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.2986},
    {"odometry's steady drift", -3.777, 0.9974, 0.0936},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2258},
    {"path", 5.108, 0.8768, 0.4151},
    {"place of a visit", -3.49, 1.364, 0.5034},
    {"place of the loosest visit", -2.75, 1.351, -0.1588},
    {"seen again", 0.9679, 0.05268, 0.1529},
    {"strain of loops", -0.9129, 0.9004, 0.3085},
    {"visits", 3.547, 0.9147, 0.06264},
    {"visits on one passage", 0.04916, 0.1264, 0.2164},
    {"worst visit's hits in free space", -3.226, 1.424, 0.225},
};
static constexpr LearntTerm kLaserHeading[] = {
    {"contradiction in matches", -2.214, 0.639, -0.1394},
    {"doubled walls", -3.424, 0.5713, 0.8022},
    {"echoes a reading", 5.363, 1.167, -0.1138},
    {"hits in free space", -4.665, 1.385, -0.3387},
    {"loops a visit", 1.383, 0.4549, -0.1656},
    {"matches accepted", 0.618, 0.2082, -0.1962},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.1133},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.1472},
    {"odometry's steady drift", -3.777, 0.9974, 0.01278},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2287},
    {"path", 5.108, 0.8768, -0.09097},
    {"place of a visit", -3.49, 1.364, 1.259},
    {"place of the loosest visit", -2.75, 1.351, -1.074},
    {"seen again", 0.9679, 0.05268, 0.1854},
    {"strain of loops", -0.9129, 0.9004, 0.3703},
    {"visits", 3.547, 0.9147, 0.549},
    {"visits on one passage", 0.04916, 0.1264, 0.1195},
    {"worst visit's hits in free space", -3.226, 1.424, 0.04081},
};
static constexpr LearntTerm kLaserScale[] = {
    {"contradiction in matches", -2.214, 0.639, -0.2325},
    {"doubled walls", -3.424, 0.5713, 0.09007},
    {"echoes a reading", 5.363, 1.167, -0.1343},
    {"hits in free space", -4.665, 1.385, -0.1735},
    {"loops a visit", 1.383, 0.4549, 0.007027},
    {"matches accepted", 0.618, 0.2082, -0.1217},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.08697},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.2352},
    {"odometry's steady drift", -3.777, 0.9974, 0.0548},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2975},
    {"path", 5.108, 0.8768, 0.3409},
    {"place of a visit", -3.49, 1.364, 1.246},
    {"place of the loosest visit", -2.75, 1.351, -1.139},
    {"seen again", 0.9679, 0.05268, 0.1526},
    {"strain of loops", -0.9129, 0.9004, 0.3262},
    {"visits", 3.547, 0.9147, -0.2859},
    {"visits on one passage", 0.04916, 0.1264, -0.02841},
    {"worst visit's hits in free space", -3.226, 1.424, 0.3035},
};
static constexpr LearntTerm kLaserVisitRight[] = {
    {"doubled walls", -3.417, 0.5661, -0.1504}, {"hits in free space", -5.078, 1.536, -0.1985},
    {"loops", 2.013, 0.6723, 0.3286},           {"place", -3.707, 1.522, -0.4784},
    {"seen again", 0.9235, 0.063, 0.02359},     {"map", 1.878, 3.821, 2.461},
};
static constexpr LearntTerm kLaserVisitPlace[] = {
    {"doubled walls", -3.417, 0.5661, 0.02836}, {"hits in free space", -5.078, 1.536, -0.03438},
    {"loops", 2.013, 0.6723, -0.09335},         {"place", -3.707, 1.522, 0.1806},
    {"seen again", 0.9235, 0.063, -0.1467},     {"map", 1.878, 3.821, -0.8589},
};

}  // namespace

const LearntModel& laser_model() {
  static const LearntModel kModel{0.0,
                                  {2.456, kLaserRight},
                                  {-2.724, kLaserPlace},
                                  {-0.07241, kLaserHeading},
                                  {-5.569, kLaserScale},
                                  {3.715, kLaserVisitRight},
                                  {-2.959, kLaserVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
