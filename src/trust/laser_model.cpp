// SPDX-License-Identifier: GPL-3.0-or-later
// Printed by `bench_trust train laser`, from 227 missions, 166 of them right, with 10860 visits.
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
    {"contradiction in matches", -2.214, 0.639, -0.05646},
    {"doubled walls", -3.424, 0.5713, 0.4908},
    {"echoes a reading", 5.363, 1.167, -0.1369},
    {"hits in free space", -4.665, 1.385, 0.3262},
    {"loops a visit", 1.383, 0.4549, -0.2755},
    {"matches accepted", 0.618, 0.2082, -0.08079},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.1392},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.007801},
    {"odometry's steady drift", -3.777, 0.9974, 0.1423},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2258},
    {"path", 5.108, 0.8768, 0.5515},
    {"place of a visit", -3.49, 1.364, 0.7072},
    {"place of the loosest visit", -2.75, 1.351, 0.2921},
    {"seen again", 0.9679, 0.05268, 0.2804},
    {"strain of loops", -0.9129, 0.9004, 0.08405},
    {"visits", 3.547, 0.9147, -0.2803},
    {"visits on one passage", 0.04916, 0.1264, 0.1096},
    {"worst visit's hits in free space", -3.226, 1.424, -0.0443},
};
static constexpr LearntTerm kLaserHeading[] = {
    {"contradiction in matches", -2.214, 0.639, -0.09548},
    {"doubled walls", -3.424, 0.5713, 0.9477},
    {"echoes a reading", 5.363, 1.167, -0.1329},
    {"hits in free space", -4.665, 1.385, -0.2436},
    {"loops a visit", 1.383, 0.4549, -0.1531},
    {"matches accepted", 0.618, 0.2082, -0.1626},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.1453},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.01036},
    {"odometry's steady drift", -3.777, 0.9974, 0.03906},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2287},
    {"path", 5.108, 0.8768, -0.2041},
    {"place of a visit", -3.49, 1.364, 1.33},
    {"place of the loosest visit", -2.75, 1.351, -1.047},
    {"seen again", 0.9679, 0.05268, 0.1908},
    {"strain of loops", -0.9129, 0.9004, 0.513},
    {"visits", 3.547, 0.9147, 0.5295},
    {"visits on one passage", 0.04916, 0.1264, 0.1886},
    {"worst visit's hits in free space", -3.226, 1.424, 0.07656},
};
static constexpr LearntTerm kLaserScale[] = {
    {"contradiction in matches", -2.214, 0.639, -0.01547},
    {"doubled walls", -3.424, 0.5713, 0.5816},
    {"echoes a reading", 5.363, 1.167, -0.1169},
    {"hits in free space", -4.665, 1.385, 0.4238},
    {"loops a visit", 1.383, 0.4549, 0.1593},
    {"matches accepted", 0.618, 0.2082, -0.3253},
    {"odometry's headings against the map's", -3.285, 0.5606, 0.05584},
    {"odometry's lengths against the map's", -2.407, 0.7082, 0.001267},
    {"odometry's steady drift", -3.777, 0.9974, 0.1555},
    {"passages in which the robot was lost", 0.07728, 0.3526, 0.2975},
    {"path", 5.108, 0.8768, 0.9071},
    {"place of a visit", -3.49, 1.364, 1.593},
    {"place of the loosest visit", -2.75, 1.351, -0.6774},
    {"seen again", 0.9679, 0.05268, 0.365},
    {"strain of loops", -0.9129, 0.9004, -0.0005772},
    {"visits", 3.547, 0.9147, -1.162},
    {"visits on one passage", 0.04916, 0.1264, 0.04873},
    {"worst visit's hits in free space", -3.226, 1.424, -0.2287},
};
static constexpr LearntTerm kLaserVisitRight[] = {
    {"doubled walls", -3.417, 0.5661, -0.1504}, {"hits in free space", -5.078, 1.536, -0.1985},
    {"loops", 2.013, 0.6723, 0.3286},           {"place", -3.707, 1.522, -0.4784},
    {"seen again", 0.9235, 0.063, 0.02359},     {"map", 1.878, 3.821, 2.461},
};
static constexpr LearntTerm kLaserVisitPlace[] = {
    {"doubled walls", -3.417, 0.5661, -0.02805},
    {"hits in free space", -5.078, 1.536, 0.1621},
    {"loops", 2.013, 0.6723, -0.239},
    {"place", -3.707, 1.522, 0.2314},
    {"seen again", 0.9235, 0.063, -0.1104},
    {"map", 1.878, 3.821, -1.409},
};

}  // namespace

const LearntModel& laser_model() {
  static const LearntModel kModel{0.0,
                                  {2.456, kLaserRight},
                                  {-1.916, kLaserPlace},
                                  {0.6009, kLaserHeading},
                                  {-4.753, kLaserScale},
                                  {3.715, kLaserVisitRight},
                                  {-2.241, kLaserVisitPlace}};
  return kModel;
}

}  // namespace roomatlas
