// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms matched by their walls as measurements of the correction, and how much edges are trusted.
#include <gtest/gtest.h>

#include <cmath>

#include "correct/corrected.hpp"

namespace roomatlas {
namespace {

using test::chain_mission;
using test::corrected;
using test::largest_error;
using test::options_of;
using test::round_the_block;

/// Not diagonal: 5 cm along a corridor that lies aslant in the frame of `to`, 2 cm across.
Eigen::Matrix3d slanted_information() {
  const double angle = 0.6;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Eigen::Vector3d sigmas(0.05, 0.02, 0.004);
  return turn * sigmas.cwiseProduct(sigmas).cwiseInverse().asDiagonal() * turn.transpose();
}

PassageEdge matched(AsrId from, AsrId to, const Pose2& from_from_to) {
  PassageEdge edge;
  edge.from = from;
  edge.to = to;
  edge.from_from_to = from_from_to;
  edge.kind = PassageKind::open_passage;
  edge.source = EdgeSource::matched;
  edge.information = slanted_information();
  return edge;
}

/// The true pose of one visit in the frame of another.
PassageEdge true_match(const std::vector<test::Visit>& visits, AsrId from, AsrId to) {
  return matched(from, to,
                 inverse(visits[static_cast<std::size_t>(from - 1)].entered_at) *
                     visits[static_cast<std::size_t>(to - 1)].entered_at);
}

CorrectOptions edges_alone(CorrectionModel model) {
  CorrectOptions options = options_of(model);
  options.use_wall_directions = false;
  return options;
}

Eigen::Matrix3d diagonal(double position_m, double heading_deg) {
  const double heading_rad = radians(heading_deg);
  return Eigen::Vector3d(1.0 / (position_m * position_m), 1.0 / (position_m * position_m),
                         1.0 / (heading_rad * heading_rad))
      .asDiagonal();
}

void expect_near(const Eigen::Matrix3d& found, const Eigen::Matrix3d& expected) {
  EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm()) << found << "\n\n" << expected;
}

TEST(InformationOf, AMatchedEdgeIsItsOwn) {
  EXPECT_EQ(information_of(matched(1, 2, {1.0, 2.0, 0.3}), {}), slanted_information());
}

TEST(InformationOf, OtherEdgesFollowFromTheirSigmas) {
  CorrectOptions options;
  options.localized_position_m = 0.04;
  options.localized_heading_deg = 0.7;
  options.doorway_position_m = 0.1;
  options.doorway_heading_deg = 3.0;
  options.odometry = {.position = {.still = 0.05, .per_m = 0.01},
                      .heading = {.still = radians(1.0), .per_m = radians(0.5), .per_rad = 0.1}};
  PassageEdge edge;
  edge.path_length_m = 10.0;
  edge.turning.absolute_rad = radians(30.0);
  edge.source = EdgeSource::driven;
  expect_near(information_of(edge, options),
              diagonal(0.05 + 0.1, std::sqrt(1.0 + 5.0 * 5.0 + 3.0 * 3.0)));
  edge.is_localized = true;  // then neither length nor turns count
  expect_near(information_of(edge, options), diagonal(0.04, 0.7));
  edge.source = EdgeSource::recognised;
  expect_near(information_of(edge, options), diagonal(0.1, 3.0));
}

TEST(MatchedEdges, CloseALoopWhereverTheirRoomsBegin) {
  const auto visits = round_the_block(2.0);
  const Placement truth = test::true_placement(visits);
  const auto asrs = chain_mission(visits);
  const double before_m = largest_error(test::odometry_placement(asrs), truth).position_m;
  ASSERT_GT(before_m, 1.0);
  // the frames of 1 and 5 lie 8 m apart, those of 2 and 6 at the same door
  const std::vector<PassageEdge> matches = {true_match(visits, 1, 5), true_match(visits, 2, 6)};
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction = corrected(asrs, edges_alone(model), matches);
    EXPECT_TRUE(correction.converged) << correction.message;
    const Placement placement = placement_of(correction);
    EXPECT_LT(largest_error(placement, truth).position_m, before_m / 2.0) << correction.model;
    for (const PassageEdge& match : matches) {
      const Pose2 off =
          inverse(match.from_from_to) * inverse(placement.at(match.from)) * placement.at(match.to);
      EXPECT_LT(off.position().norm(), 0.3) << correction.model << " " << match.to;
      EXPECT_LT(std::abs(degrees(off.theta_rad)), 1.0) << correction.model << " " << match.to;
    }
  }
}

TEST(MatchedEdges, WithRotationsAloneThePivotsEndWhereTheMatchSaysNotWhereItsRoomBegins) {
  // exact odometry: a true match leaves everything, whatever lies between the two frames
  const auto visits = round_the_block(0.0);
  const auto asrs = chain_mission(visits);
  for (const AsrId to : {3, 5, 6}) {
    const Correction correction =
        corrected(asrs, edges_alone(CorrectionModel::rotation_only), {true_match(visits, 1, to)});
    for (const AsrCorrection& asr : correction.asrs) EXPECT_LT(asr.moved_m, 1e-6) << to;
    EXPECT_LT(correction.final_cost, 1e-9) << to;
  }
}

TEST(MatchedEdges, OneThatDoesNotKnowItsPositionMovesLittle) {
  const auto visits = round_the_block(0.0);
  auto asrs = chain_mission(visits);
  for (Asr& asr : asrs) asr.is_localized = true;  // the loop is known to half a metre ...
  PassageEdge match = true_match(visits, 2, 6);
  match.from_from_to.x_m += 1.5;  // ... which this does not contradict
  match.information = diagonal(3.0, 0.2);
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction = corrected(asrs, edges_alone(model), {match});
    for (const AsrCorrection& asr : correction.asrs) {
      EXPECT_LT(asr.moved_m, 0.1) << correction.model << ", ASR " << asr.asr;
    }
  }
}

TEST(MatchedEdges, ChiSquareIsTheLiteralFormulaWithAnInformationThatIsNotDiagonal) {
  const auto asrs = chain_mission(round_the_block(2.0));
  const PassageEdge match = matched(2, 6, {0.1, -0.2, 0.05});
  const Correction correction = corrected(asrs, edges_alone(CorrectionModel::se2), {match});
  const Placement odometry = test::odometry_placement(asrs);
  const auto chi_square = [&](const Placement& placement) {
    const Pose2 off = inverse(match.from_from_to) * inverse(placement.at(2)) * placement.at(6);
    const Eigen::Vector3d error(off.x_m, off.y_m, off.theta_rad);
    return error.dot(match.information * error);
  };
  const FactorReport& factor = correction.factors.back();
  ASSERT_EQ(factor.kind, FactorKind::closure);
  EXPECT_EQ(factor.from, 2);
  EXPECT_EQ(factor.to, 6);
  const double before = chi_square(odometry);
  const double after = chi_square(placement_of(correction));
  EXPECT_NEAR(factor.chi_square_before, before, 1e-6 * before);
  EXPECT_NEAR(factor.chi_square_after, after, 1e-6 * before);
}

TEST(MatchedEdges, AFalseOneAmongTrueOnesLosesItsWeight) {
  const auto visits = round_the_block(0.5);
  const auto asrs = chain_mission(visits);
  PassageEdge wrong = true_match(visits, 2, 4);
  wrong.from_from_to = wrong.from_from_to * Pose2{3.0, -2.0, 0.4};
  for (const auto model : {CorrectionModel::se2, CorrectionModel::rotation_only}) {
    const Correction correction = corrected(
        asrs, edges_alone(model), {true_match(visits, 1, 5), true_match(visits, 2, 6), wrong});
    const FactorReport& factor = correction.factors.back();
    ASSERT_EQ(factor.to, 4);
    EXPECT_LT(factor.weight, 0.1) << correction.model;
    EXPECT_LT(largest_error(placement_of(correction), test::true_placement(visits)).position_m, 0.5)
        << correction.model;
  }
}

TEST(MatchedEdges, AKnownStartDoesNotChangeTheAnswer) {
  const auto visits = round_the_block(2.0);
  const auto asrs = chain_mission(visits);
  RoomGraph graph = build_graph(asrs);
  add_edge(graph, true_match(visits, 1, 5));
  const CorrectOptions options = edges_alone(CorrectionModel::se2);
  const Placement from_odometry = placement_of(correct(asrs, graph, options));
  const Placement from_truth =
      placement_of(correct(asrs, graph, options, test::true_placement(visits)));
  const auto apart = largest_error(from_truth, from_odometry);
  EXPECT_LT(apart.position_m, 1e-3);
  EXPECT_LT(apart.heading_deg, 0.01);
}

}  // namespace
}  // namespace roomatlas
