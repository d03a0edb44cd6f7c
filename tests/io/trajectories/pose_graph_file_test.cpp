// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/core/issue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace roomatlas {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

PoseGraphFile read(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_pose_graph(folder.write("x.g2o", text));
}

void expect_refused(const std::string& text, const std::string& place, const std::string& why) {
  EXPECT_THAT([&] { (void)read(text); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("x.g2o" + place), HasSubstr(why))));
}

const Eigen::Matrix3d kInformation = (Eigen::Matrix3d() << 11, 1, 2, 1, 22, 3, 2, 3, 33).finished();

TEST(PoseGraphFile, ReadsBothOrdersOfTheInformationMatrix) {
  const PoseGraphFile g2o = read("EDGE_SE2 4 5 1 2 0.5 11 1 2 22 3 33\n");
  const PoseGraphFile toro = read("EDGE2 4 5 1 2 0.5 11 1 22 33 2 3\n");
  EXPECT_EQ(g2o.graph.edges.at(0).information, kInformation);
  EXPECT_EQ(toro.graph.edges.at(0).information, kInformation);
  EXPECT_EQ(g2o.graph.edges[0].from_from_to, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(g2o.g2o_lines, 1);
  EXPECT_EQ(toro.toro_lines, 1);
}

TEST(PoseGraphFile, NodesComeFromTheEdgesWhereThereAreNoVertices) {
  const PoseGraphFile file = read(
      "EDGE_SE2 7 8 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 3 8 1 0 0 1 0 0 1 0 1\n");
  EXPECT_EQ(file.graph.ids, (std::vector<std::int64_t>{7, 8, 3}));
  EXPECT_TRUE(file.graph.guess.empty());
  EXPECT_EQ(file.graph.edges[1].from, 2);
}

TEST(PoseGraphFile, VerticesMayStandBehindTheirEdgesAndGiveTheGuess) {
  const PoseGraphFile file = read(
      "# a comment\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
      "VERTEX_SE2 1 1 2 7\n\n"
      "VERTEX_SE2 0 0 0 0\n");
  EXPECT_EQ(file.graph.ids, (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(file.graph.edges[0].from, 1);
  EXPECT_DOUBLE_EQ(file.graph.guess[0].theta_rad, wrap_angle(7.0));
}

TEST(PoseGraphFile, NeighbouringIdsAreOdometryInEitherDirection) {
  const std::string rest = " 1 0 0 1 0 0 1 0 1\n";
  const PoseGraph graph =
      read("EDGE_SE2 1 2" + rest + "EDGE_SE2 3 2" + rest + "EDGE_SE2 1 3" + rest).graph;
  EXPECT_EQ(graph.edges[0].kind, EdgeKind::odometry);
  EXPECT_EQ(graph.edges[1].kind, EdgeKind::odometry);
  EXPECT_EQ(graph.edges[2].kind, EdgeKind::loop);
}

TEST(PoseGraphFile, WhatIsNotUsedIsCountedAndSaid) {
  const PoseGraphFile file = read("EDGE2 0 1 1 0 0 1 0 1 1 0 0\nEQUIV 1 0\nEQUIV 2 0\nFIX 0\n");
  EXPECT_EQ(file.ignored_lines.at("EQUIV"), 2);
  EXPECT_EQ(file.ignored_lines.at("FIX"), 1);
  ASSERT_EQ(file.issues.size(), 2U);
  EXPECT_THAT(to_string(file.issues[0]), AllOf(HasSubstr("EQUIV"), HasSubstr("2 lines")));
}

TEST(PoseGraphFile, WhatIsWrongIsNamedWithItsLine) {
  const std::string vertex = "VERTEX_SE2 0 0 0 0\n";
  const std::string edge = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n";
  expect_refused(edge + "EDGE_SE2 1 2 nan 0 0 1 0 0 1 0 1\n", ":2:", "x: expected a finite");
  expect_refused(edge + "EDGE_SE2 1 2 1 0 0 1 0 0 1 0\n", ":2:", "I33");
  expect_refused(edge + "EDGE_SE2 1 two 1 0 0 1 0 0 1 0 1\n", ":2:", "to: expected a whole");
  expect_refused(edge + "EDGE_SE2 1 2 1 0 0 -1 0 0 1 0 1\n", ":2:", "negative eigenvalue");
  expect_refused(edge + "EDGE_SE2 1 2 1 0 0 1 5 0 1 0 1\n", ":2:", "negative eigenvalue");
  expect_refused(edge + "EDGE_SE2 2 2 1 0 0 1 0 0 1 0 1\n", ":2:", "with itself");
  expect_refused(vertex + "VERTEX_SE2 1 0 0 0\n" + vertex, ":3:", "first in line 1");
  expect_refused(vertex + edge, ":2:", "vertex 1");
  expect_refused("hello\n", "", "EDGE_SE2");
}

TEST(PoseGraphFile, WritesWhatItReads) {
  const PoseGraphFile file = read(
      "VERTEX_SE2 5 0.1 -2.25 0.3\nVERTEX_SE2 6 1e-7 2 -3\n"
      "EDGE_SE2 5 6 1 2 0.5 11 1 2 22 3 33\nEDGE_SE2 6 5 1 2 0.5 11 1 2 22 3 33\n");
  const test::TemporaryFolder folder;
  write_g2o(folder / "y.g2o", file.graph, file.graph.guess, {});
  const PoseGraphFile again = read_pose_graph(folder / "y.g2o");
  EXPECT_EQ(again.graph.ids, file.graph.ids);
  EXPECT_EQ(again.graph.guess, file.graph.guess);
  ASSERT_EQ(again.graph.edges.size(), 2U);
  EXPECT_EQ(again.graph.edges[0].information, kInformation);
  EXPECT_EQ(again.graph.edges[1].from_from_to, file.graph.edges[1].from_from_to);
}

TEST(PoseGraphFile, RejectedEdgesAreWrittenAsComments) {
  const PoseGraphFile file = read(
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 2 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n");
  const test::TemporaryFolder folder;
  const std::vector<Pose2> poses(3);
  const std::vector<std::uint8_t> accepted = {1, 0, 1};
  write_g2o(folder / "y.g2o", file.graph, poses, accepted);
  EXPECT_EQ(read_pose_graph(folder / "y.g2o").graph.edges.size(), 2U);
  EXPECT_THAT(test::bytes_of(folder / "y.g2o"), HasSubstr("# rejected: EDGE_SE2 0 2"));
}

}  // namespace
}  // namespace roomatlas
