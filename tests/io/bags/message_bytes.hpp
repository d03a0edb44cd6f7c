// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/bag_reader.hpp"

#include "roomatlas/core/pose2.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace roomatlas::test {

/// How a test's messages are laid out.
enum class Layout { ros1, cdr_little, cdr_big };

/// Serializes fields in turn, by the rules of the layout and without a look at who reads them.
class MessageBytes {
 public:
  explicit MessageBytes(Layout layout) : layout_(layout) {
    if (layout == Layout::cdr_little) raw({0, 1, 0, 0});
    if (layout == Layout::cdr_big) raw({0, 0, 0, 0});
    start_ = bytes.size();
  }

  template <typename Number>
  MessageBytes& add(Number number) {
    if (layout_ != Layout::ros1) {
      while ((bytes.size() - start_) % sizeof(Number) != 0) bytes.push_back(std::byte{0});
    }
    std::vector<std::byte> of_number(sizeof(Number));
    std::uint64_t bits = 0;
    if constexpr (std::is_same_v<Number, float>) {
      bits = std::bit_cast<std::uint32_t>(number);
    } else if constexpr (std::is_same_v<Number, double>) {
      bits = std::bit_cast<std::uint64_t>(number);
    } else {
      bits = static_cast<std::uint64_t>(number);
    }
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      const std::size_t place = layout_ == Layout::cdr_big ? sizeof(Number) - 1 - i : i;
      of_number[place] = static_cast<std::byte>(bits >> (8 * i));
    }
    bytes.insert(bytes.end(), of_number.begin(), of_number.end());
    return *this;
  }
  MessageBytes& text(const std::string& text) {
    const bool ends_with_nul = layout_ != Layout::ros1;
    add(static_cast<std::uint32_t>(text.size() + (ends_with_nul ? 1 : 0)));
    for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
    if (ends_with_nul) bytes.push_back(std::byte{0});
    return *this;
  }
  MessageBytes& header(double stamp_s, const std::string& frame) {
    if (layout_ == Layout::ros1) add(std::uint32_t{7});  // its number
    const auto whole_s = static_cast<std::int32_t>(std::floor(stamp_s));
    add(whole_s).add(static_cast<std::uint32_t>(std::llround((stamp_s - whole_s) * 1e9)));
    return text(frame);
  }
  MessageBytes& pose(double x, double y, double z, double roll, double yaw) {
    add(x).add(y).add(z);
    const double cr = std::cos(roll / 2.0), sr = std::sin(roll / 2.0);
    const double cy = std::cos(yaw / 2.0), sy = std::sin(yaw / 2.0);
    return add(sr * cy).add(sr * sy).add(cr * sy).add(cr * cy);
  }
  MessageBytes& floats(const std::vector<float>& values) {
    add(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) add(value);
    return *this;
  }

  std::vector<std::byte> bytes;

 private:
  void raw(std::initializer_list<int> values) {
    for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  }
  Layout layout_;
  std::size_t start_ = 0;
};

[[nodiscard]] inline io::BagEncoding encoding_of(Layout layout) {
  return layout == Layout::ros1 ? io::BagEncoding::ros1 : io::BagEncoding::cdr;
}

/// A laser scan's fields that tests change.
struct ScanFields {
  double stamp_s = 0.0;
  std::string frame = "laser";
  float angle_min = -1.0F;
  float angle_increment = 0.5F;
  float time_increment = 0.0F;
  float scan_time = 0.0F;
  float range_min = 0.1F;
  float range_max = 10.0F;
  std::vector<float> ranges{1.0F, 2.0F, 3.0F, 4.0F, 5.0F};
};

[[nodiscard]] inline std::vector<std::byte> scan_bytes(const ScanFields& scan,
                                                       Layout layout = Layout::ros1) {
  MessageBytes out(layout);
  out.header(scan.stamp_s, scan.frame).add(scan.angle_min);
  out.add(scan.angle_min + scan.angle_increment * static_cast<float>(scan.ranges.size() - 1));
  out.add(scan.angle_increment).add(scan.time_increment).add(scan.scan_time);
  out.add(scan.range_min).add(scan.range_max).floats(scan.ranges).floats({});
  return out.bytes;
}

[[nodiscard]] inline std::vector<std::byte> odometry_bytes(double stamp_s, const Pose2& pose,
                                                           const std::string& frame = "odom",
                                                           const std::string& child = "base_link",
                                                           Layout layout = Layout::ros1) {
  MessageBytes out(layout);
  out.header(stamp_s, frame).text(child).pose(pose.x_m, pose.y_m, 0.0, 0.0, pose.theta_rad);
  for (int i = 0; i < 36 + 6 + 36; ++i) out.add(0.0);
  return out.bytes;
}

/// A transform as tests write it; the roll turns a laser upside down.
struct TransformFields {
  std::string parent;
  std::string child;
  Pose2 pose;
  double roll_rad = 0.0;
  double z_m = 0.0;
};

[[nodiscard]] inline std::vector<std::byte> tf_bytes(double stamp_s,
                                                     const std::vector<TransformFields>& transforms,
                                                     Layout layout = Layout::ros1) {
  MessageBytes out(layout);
  out.add(static_cast<std::uint32_t>(transforms.size()));
  for (const TransformFields& t : transforms) {
    out.header(stamp_s, t.parent).text(t.child);
    out.pose(t.pose.x_m, t.pose.y_m, t.z_m, t.roll_rad, t.pose.theta_rad);
  }
  return out.bytes;
}

}  // namespace roomatlas::test
