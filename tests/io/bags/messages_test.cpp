// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/messages.hpp"

#include "io/bags/message_bytes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace roomatlas::test {
namespace {

using io::MessageCursor;
using io::MessageKind;

constexpr Layout kLayouts[] = {Layout::ros1, Layout::cdr_little, Layout::cdr_big};

MessageCursor cursor(const std::vector<std::byte>& bytes, Layout layout) {
  return {bytes, encoding_of(layout)};
}

std::vector<std::byte> cloud_bytes(Layout layout) {
  MessageBytes out(layout);
  out.header(3.5, "/lidar").add(std::uint32_t{1}).add(std::uint32_t{2});
  out.add(std::uint32_t{4});
  for (const auto& [name, offset] :
       {std::pair{"x", 0}, std::pair{"y", 4}, std::pair{"z", 8}, std::pair{"intensity", 12}}) {
    out.text(name).add(static_cast<std::uint32_t>(offset)).add(std::uint8_t{7});
    out.add(std::uint32_t{1});
  }
  out.add(std::uint8_t{0}).add(std::uint32_t{16}).add(std::uint32_t{32});
  out.add(std::uint32_t{32});
  MessageBytes points(Layout::ros1);  // little-endian by themselves
  for (const float value : {1.0F, 2.0F, 3.0F, 9.0F, 4.0F, 5.0F, 6.0F, 9.0F}) points.add(value);
  out.bytes.insert(out.bytes.end(), points.bytes.begin(), points.bytes.end());
  return out.bytes;
}

TEST(Messages, AScanIsReadFromEachLayout) {
  for (const Layout layout : kLayouts) {
    const auto bytes = scan_bytes({.stamp_s = 12.25, .frame = "/laser_x"}, layout);
    const auto scan = io::read_laser_scan(cursor(bytes, layout));
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->header.stamp_ns, 12'250'000'000);
    EXPECT_EQ(scan->header.frame, "laser_x");
    EXPECT_EQ(scan->angle_min_rad, -1.0);
    EXPECT_EQ(scan->angle_increment_rad, 0.5);
    EXPECT_EQ(scan->range_max_m, 10.0);
    EXPECT_EQ(scan->ranges_m, (std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F, 5.0F}));
  }
}

TEST(Messages, OdometryTransformsAndCloudsAreReadFromEachLayout) {
  for (const Layout layout : kLayouts) {
    const auto odometry = odometry_bytes(1.5, {3.0, -4.0, 2.0}, "/odom", "base", layout);
    const auto pose = io::read_odometry(cursor(odometry, layout));
    ASSERT_TRUE(pose && pose->frame_from_child);
    EXPECT_EQ(pose->header.frame, "odom");
    EXPECT_EQ(pose->child_frame, "base");
    EXPECT_NEAR(io::planar(*pose->frame_from_child).theta_rad, 2.0, 1e-12);
    EXPECT_EQ(pose->frame_from_child->translation.y(), -4.0);

    const auto tf = tf_bytes(2.0, {{"a", "b", {1.0, 2.0, 0.5}}, {"/b", "/c", {}}}, layout);
    const auto transforms = io::read_transforms(cursor(tf, layout));
    ASSERT_TRUE(transforms);
    ASSERT_EQ(transforms->size(), 2U);
    EXPECT_EQ(transforms->at(1).header.frame, "b");
    EXPECT_EQ(transforms->at(1).child_frame, "c");
    EXPECT_NEAR(io::planar(*transforms->at(0).frame_from_child).theta_rad, 0.5, 1e-12);

    const auto raw = cloud_bytes(layout);
    const auto cloud = io::read_cloud(cursor(raw, layout));
    ASSERT_TRUE(cloud);
    EXPECT_EQ(cloud->header.frame, "lidar");
    ASSERT_EQ(cloud->points.size(), 2U);
    EXPECT_EQ(cloud->points[1], Eigen::Vector3f(4.0F, 5.0F, 6.0F));
  }
}

TEST(Messages, AMultiEchoScanGivesTheFirstEchoOfEachBeam) {
  MessageBytes out(Layout::cdr_little);
  out.header(1.0, "laser").add(-1.0F).add(1.0F).add(1.0F).add(0.0F).add(0.0F).add(0.1F).add(9.0F);
  out.add(std::uint32_t{3}).floats({1.0F, 2.0F}).floats({}).floats({3.0F}).add(std::uint32_t{0});
  const auto scan = io::read_echoes(cursor(out.bytes, Layout::cdr_little));
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->ranges_m.size(), 3U);
  EXPECT_EQ(scan->ranges_m[0], 1.0F);
  EXPECT_TRUE(std::isnan(scan->ranges_m[1]));
  EXPECT_EQ(scan->ranges_m[2], 3.0F);
}

TEST(Messages, AMessageCutAnywhereIsNoMessage) {
  const auto all_cuts = [](const std::vector<std::byte>& whole, std::size_t needed, auto read) {
    for (std::size_t length = 0; length < needed; ++length) {
      const std::vector<std::byte> cut(whole.begin(),
                                       whole.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_FALSE(read(cut)) << length << " bytes";
    }
    EXPECT_TRUE(read(whole));
  };
  for (const Layout layout : kLayouts) {
    const auto scan = scan_bytes({}, layout);
    all_cuts(scan, scan.size() - 4 - 4, [&](const auto& bytes) {  // intensities are not read
      return io::read_laser_scan(cursor(bytes, layout)).has_value();
    });
    const auto tf = tf_bytes(2.0, {{"a", "b", {}}, {"b", "c", {}}}, layout);
    all_cuts(tf, tf.size(), [&](const auto& bytes) {
      return io::read_transforms(cursor(bytes, layout)).has_value();
    });
    const auto cloud = cloud_bytes(layout);
    all_cuts(cloud, cloud.size(),
             [&](const auto& bytes) { return io::read_cloud(cursor(bytes, layout)).has_value(); });
  }
}

TEST(Messages, ADamagedByteAnywhereCrashesNothing) {
  for (const Layout layout : kLayouts) {
    for (const auto& whole : {scan_bytes({}, layout), tf_bytes(2.0, {{"a", "b", {}}}, layout),
                              cloud_bytes(layout), odometry_bytes(1.0, {}, "o", "b", layout)}) {
      for (std::size_t at = 0; at < whole.size(); ++at) {
        std::vector<std::byte> damaged = whole;
        damaged[at] = std::byte{0xff};
        (void)io::read_laser_scan(cursor(damaged, layout));
        (void)io::read_echoes(cursor(damaged, layout));
        (void)io::read_transforms(cursor(damaged, layout));
        (void)io::read_cloud(cursor(damaged, layout));
        (void)io::read_odometry(cursor(damaged, layout));
      }
    }
  }
  SUCCEED();
}

TEST(Messages, ACountThatNoBytesFollowReservesNoMemory) {
  MessageBytes out(Layout::ros1);
  out.header(1.0, "laser");
  for (int i = 0; i < 7; ++i) out.add(1.0F);
  out.add(std::uint32_t{0xffffffff});
  EXPECT_FALSE(io::read_laser_scan(cursor(out.bytes, Layout::ros1)));
}

TEST(Messages, NumbersThatCannotBeATransformAreNone) {
  const auto pose_of = [](double x, double qw) {
    MessageBytes out(Layout::ros1);
    out.header(1.0, "odom").text("base").add(x).add(0.0).add(0.0);
    out.add(0.0).add(0.0).add(0.0).add(qw);
    return io::read_odometry({out.bytes, io::BagEncoding::ros1});
  };
  EXPECT_TRUE(pose_of(1.0, 1.0)->frame_from_child);
  EXPECT_TRUE(pose_of(1.0, 0.999)->frame_from_child);
  EXPECT_FALSE(pose_of(1.0, 0.0)->frame_from_child);  // never filled in
  EXPECT_FALSE(pose_of(std::nan(""), 1.0)->frame_from_child);
  EXPECT_FALSE(pose_of(1e12, 1.0)->frame_from_child);
}

TEST(Messages, ADefinitionWithOtherFieldsIsAMisfit) {
  const std::string good =
      "# a scan\nstd_msgs/Header header # when\n\nfloat32 angle_min\nfloat32 angle_max\n"
      "float32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\nfloat32 range_min\n"
      "float32 range_max\nfloat32[] ranges\nfloat32[] intensities\n=====\nMSG: std_msgs/Header\n";
  const std::string type = "sensor_msgs/LaserScan";
  EXPECT_EQ(io::misfit_of(MessageKind::laser, type, good), "");
  EXPECT_EQ(io::misfit_of(MessageKind::laser, type, ""), "");
  std::string other = good;
  other.replace(other.find("float32 range_min"), 17, "float64 range_min");
  EXPECT_EQ(io::misfit_of(MessageKind::laser, type, other),
            "expected float32 range_min, found float64 range_min");
  EXPECT_EQ(io::misfit_of(MessageKind::range, "sensor_msgs/Range",
                          "Header header\nuint8 ULTRASOUND=0\nuint8 radiation_type\n"),
            "expected float32 field_of_view, found no more fields");
}

TEST(Messages, TypesOfBothReleasesAreOne) {
  EXPECT_EQ(io::kind_of_message("sensor_msgs/msg/LaserScan"), MessageKind::laser);
  EXPECT_EQ(io::kind_of_message("sensor_msgs/LaserScan"), MessageKind::laser);
  EXPECT_EQ(io::kind_of_message("tf/tfMessage"), MessageKind::transforms);
  EXPECT_FALSE(io::kind_of_message("sensor_msgs/Image"));
  EXPECT_FALSE(io::kind_of_message("nonsense"));
}

}  // namespace
}  // namespace roomatlas::test
