// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of ROS 1 and CDR: the first byte chooses the kind, the second the encoding. And the
// texts that describe them.
#include "bags/messages.hpp"
#include "io/bags/message_bytes.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

using test::Layout;

std::string with_choice(int kind, Layout layout, const std::vector<std::byte>& bytes) {
  std::string text = {static_cast<char>(kind), layout == Layout::ros1 ? '\0' : '\1'};
  for (const std::byte byte : bytes) text += static_cast<char>(byte);
  return text;
}

std::vector<std::byte> cloud_bytes(Layout layout) {
  test::MessageBytes out(layout);
  out.header(7.0, "velodyne").add(std::uint32_t{1}).add(std::uint32_t{2});
  out.add(std::uint32_t{4});
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "time"}) {
    out.text(name).add(offset).add(std::uint8_t{7}).add(std::uint32_t{1});
    offset += 4;
  }
  out.add(std::uint8_t{0}).add(std::uint32_t{16}).add(std::uint32_t{32}).add(std::uint32_t{32});
  for (int i = 0; i < 32; ++i) out.add(static_cast<std::uint8_t>(i));
  out.add(std::uint8_t{1});
  return out.bytes;
}

std::vector<std::byte> imu_bytes(Layout layout) {
  test::MessageBytes out(layout);
  out.header(7.0, "imu");
  for (int i = 0; i < 4 + 9 + 3 + 9 + 3 + 9; ++i) out.add(0.1 * i);
  return out.bytes;
}

std::vector<std::string> message_seeds() {
  std::vector<std::string> seeds;
  for (const Layout layout : {Layout::ros1, Layout::cdr_little, Layout::cdr_big}) {
    const auto transforms =
        test::tf_bytes(3.0, {{"odom", "base", {1, 2, 3}}, {"base", "laser", {}}}, layout);
    const auto odometry = test::odometry_bytes(2.0, {1, 2, 0.5}, "odom", "base", layout);
    const auto scan = test::scan_bytes({}, layout);
    const auto put = [&](int kind, const std::vector<std::byte>& bytes) {
      seeds.push_back(with_choice(kind, layout, bytes));
    };
    for (const int kind : {0, 1, 2}) put(kind, scan);
    put(3, cloud_bytes(layout));
    for (const int kind : {4, 5, 6}) put(kind, odometry);
    put(7, transforms);
    put(8, imu_bytes(layout));
    put(9, odometry);
  }
  return seeds;
}

void read_message(const Path&, const std::string& bytes) {
  if (bytes.size() < 2) return;
  // A copy of exactly this size, so that a sanitizer sees who reads beyond it.
  const std::vector<char> copy(bytes.begin() + 2, bytes.end());
  const io::MessageCursor in(std::as_bytes(std::span(copy)),
                             bytes[1] % 2 == 0 ? io::BagEncoding::ros1 : io::BagEncoding::cdr);
  switch (static_cast<unsigned char>(bytes[0]) % 10) {
    case 0:
      return void(io::read_laser_scan(in));
    case 1:
      return void(io::read_echoes(in));
    case 2:
      return void(io::read_range(in));
    case 3:
      return void(io::read_cloud(in));
    case 4:
      return void(io::read_odometry(in));
    case 5:
      return void(io::read_pose(in));
    case 6:
      return void(io::read_transform(in));
    case 7:
      return void(io::read_transforms(in));
    case 8:
      return void(io::read_imu(in));
    default:
      return void(io::read_header(in));
  }
}

std::vector<std::string> definition_seeds() {
  return {
      "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max # [rad]\n"
      "float32[] ranges\n=====\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n",
      "# a comment\nint32 X=1\ngeometry_msgs/TransformStamped[] transforms\n"
      "=====\nMSG: geometry_msgs/TransformStamped\nHeader header\nstring child_frame_id\n"};
}

void read_definition(const Path&, const std::string& text) {
  for (const char* type : {"sensor_msgs/LaserScan", "sensor_msgs/PointCloud2", "nav_msgs/Odometry",
                           "tf2_msgs/TFMessage", "sensor_msgs/Imu", "sensor_msgs/Range"}) {
    if (const auto kind = io::kind_of_message(type)) (void)io::misfit_of(*kind, type, text);
  }
}

}  // namespace

std::vector<Target> message_targets() {
  return {{"messages", "message", message_seeds, read_message},
          {"message_definitions", "definition", definition_seeds, read_definition}};
}

}  // namespace roomatlas::fuzz
