// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_relation.hpp"

#include <cmath>

namespace roomatlas {
namespace evaluation {

double size_of(const Pose2& error, PoseRelation relation) {
  // ||R(theta) - I||_F: both rows of the turning block differ by the chord 2 sin(theta / 2).
  const double turn = 2.0 * std::sqrt(2.0) * std::abs(std::sin(error.theta_rad / 2.0));
  switch (relation) {
    case PoseRelation::full:
      return std::hypot(turn, error.position().norm());
    case PoseRelation::rot_part:
      return turn;
    case PoseRelation::angle_deg:
      return degrees(std::abs(error.theta_rad));
    case PoseRelation::angle_rad:
      return std::abs(error.theta_rad);
    case PoseRelation::trans_part:
    case PoseRelation::point_distance:
    case PoseRelation::point_distance_error_ratio:
      break;
  }
  return error.position().norm();
}

}  // namespace evaluation

const char* to_string(PoseRelation relation) {
  switch (relation) {
    case PoseRelation::full:
      return "full";
    case PoseRelation::rot_part:
      return "rot_part";
    case PoseRelation::angle_deg:
      return "angle_deg";
    case PoseRelation::angle_rad:
      return "angle_rad";
    case PoseRelation::point_distance:
      return "point_distance";
    case PoseRelation::point_distance_error_ratio:
      return "point_distance_error_ratio";
    case PoseRelation::trans_part:
      break;
  }
  return "trans_part";
}

const char* title_of(PoseRelation relation) {
  switch (relation) {
    case PoseRelation::full:
      return "full transformation";
    case PoseRelation::rot_part:
      return "rotation part";
    case PoseRelation::angle_deg:
    case PoseRelation::angle_rad:
      return "rotation angle";
    case PoseRelation::point_distance:
      return "point distance";
    case PoseRelation::point_distance_error_ratio:
      return "point distance error ratio";
    case PoseRelation::trans_part:
      break;
  }
  return "translation part";
}

const char* unit_of(PoseRelation relation) {
  switch (relation) {
    case PoseRelation::trans_part:
    case PoseRelation::point_distance:
      return "m";
    case PoseRelation::angle_deg:
      return "deg";
    case PoseRelation::angle_rad:
      return "rad";
    case PoseRelation::point_distance_error_ratio:
      return "%";
    case PoseRelation::full:
    case PoseRelation::rot_part:
      break;
  }
  return "";
}

}  // namespace roomatlas
