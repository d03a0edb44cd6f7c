// SPDX-License-Identifier: GPL-3.0-or-later
// Values as bytes, bit by bit, for programs of one version on machines of one kind.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "roomatlas/core/pose2.hpp"

namespace roomatlas {

/// A value, constant or not. A type is packed by a function `fields_of(value, visit)` that calls
/// `visit` with its fields, both ways: constant values go into a Packer, others come out of an
/// Unpacker.
template <typename Value, typename Plain>
concept MaybeConst = std::is_same_v<std::remove_const_t<Value>, Plain>;

/// A vector or a deque.
template <typename Value>
concept Sequence = requires(Value& values) {
  values.push_back(*values.begin());
  values.resize(values.size());
};

/// Appends whatever it is called with.
class Packer {
 public:
  template <typename... Values>
  void operator()(const Values&... values) {
    (add(values), ...);
  }
  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  template <typename Value>
  void add(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else if constexpr (Sequence<Value>) {
      add(value.size());
      for (const auto& one : value) add(one);
    } else {
      fields_of(value, *this);
    }
  }
  template <typename Value>
  void add(const std::optional<Value>& value) {
    add(value.has_value());
    if (value) add(*value);
  }

  std::string bytes_;
};

/// Reads them back, in the same order. Throws std::logic_error where the bytes end too early or
/// hold a count that cannot be.
class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  template <typename Value>
  void read(Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      if (bytes_.size() - at_ < sizeof value) throw std::logic_error("packed bytes end too early");
      std::memcpy(&value, bytes_.data() + at_, sizeof value);
      at_ += sizeof value;
    } else if constexpr (Sequence<Value>) {
      std::size_t count = 0;
      read(count);
      if (count > bytes_.size()) throw std::logic_error("packed bytes hold a wrong count");
      value.resize(count);
      for (auto& one : value) read(one);
    } else {
      fields_of(value, *this);
    }
  }
  void read(bool& value) {  // no other bytes than these two are one
    std::uint8_t byte = 0;
    read(byte);
    value = byte != 0;
  }
  template <typename Value>
  void read(std::optional<Value>& value) {
    bool has_value = false;
    read(has_value);
    value.reset();
    if (has_value) read(value.emplace());
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <MaybeConst<Pose2> Value, typename Visit>
void fields_of(Value& pose, Visit& visit) {
  visit(pose.x_m, pose.y_m, pose.theta_rad);
}
/// A matrix or a vector of a fixed size.
template <typename Value, typename Visit>
requires(std::remove_const_t<Value>::SizeAtCompileTime > 0) void fields_of(Value& matrix,
                                                                           Visit& visit) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) visit(matrix.data()[i]);
}

template <typename Value>
[[nodiscard]] std::string packed(const Value& value) {
  Packer packer;
  packer(value);
  return std::move(packer).bytes();
}

template <typename Value>
[[nodiscard]] Value unpacked(const std::string& bytes) {
  Value value;
  Unpacker unpacker(bytes);
  unpacker(value);
  return value;
}

}  // namespace roomatlas
