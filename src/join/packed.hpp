// SPDX-License-Identifier: GPL-3.0-or-later
// Results as bytes, for processes of one program on machines of one kind.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "roomatlas/core/workers.hpp"
#include "roomatlas/join/place_mission.hpp"
#include "roomatlas/loops/closures.hpp"

namespace roomatlas {

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
    } else {
      fields_of(value, *this);
    }
  }
  template <typename Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    for (const Value& value : values) add(value);
  }

  std::string bytes_;
};

/// Reads them back, in the same order.
class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

 private:
  template <typename Value>
  void read(Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      if (bytes_.size() - at_ < sizeof value) throw std::logic_error("packed bytes end too early");
      std::memcpy(&value, bytes_.data() + at_, sizeof value);
      at_ += sizeof value;
    } else {
      fields_of(value, *this);
    }
  }
  template <typename Value>
  void read(std::vector<Value>& values) {
    std::size_t count = 0;
    read(count);
    if (count > bytes_.size()) throw std::logic_error("packed bytes hold a wrong count");
    values.resize(count);
    for (Value& value : values) read(value);
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

// Which fields go, and in which order, both ways: constant values into a Packer, others out of an
// Unpacker.

template <typename Value, typename Plain>
concept MaybeConst = std::is_same_v<std::remove_const_t<Value>, Plain>;

template <MaybeConst<Pose2> Value, typename Visit>
void fields_of(Value& pose, Visit& visit) {
  visit(pose.x_m, pose.y_m, pose.theta_rad);
}
template <MaybeConst<Eigen::Matrix3d> Value, typename Visit>
void fields_of(Value& matrix, Visit& visit) {
  for (int i = 0; i < 9; ++i) visit(matrix.data()[i]);
}
template <MaybeConst<PlaceHypothesis> Value, typename Visit>
void fields_of(Value& place, Visit& visit) {
  visit(place.building_from_query, place.agreeing, place.contradicting, place.unseen, place.missing,
        place.score);
}
template <MaybeConst<PlacedPiece> Value, typename Visit>
void fields_of(Value& piece, Visit& visit) {
  visit(piece.visits, piece.place, piece.is_inside, piece.fits);
}
template <MaybeConst<MissionPlace> Value, typename Visit>
void fields_of(Value& place, Visit& visit) {
  visit(place.building_from_mission, place.pieces, place.score, place.agreeing,
        place.contradicting);
}
template <MaybeConst<MapMatch> Value, typename Visit>
void fields_of(Value& match, Visit& visit) {
  visit(match.first_from_second, match.agreeing, match.contradicting, match.unseen,
        match.information);
}
template <MaybeConst<Closure> Value, typename Visit>
void fields_of(Value& closure, Visit& visit) {
  visit(closure.from, closure.to, closure.match, closure.verdict, closure.was_given);
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

/// The results of `make(i)` for each i in [0, count), in that order, made by all workers.
/// @param jobs threads at once in each process, see `Workers::shared`
template <typename Result, typename Make>
[[nodiscard]] std::vector<Result> made_by(const Workers& workers, std::size_t count, int jobs,
                                          const Make& make) {
  if (!workers.is_shared()) return results_of<Result>(count, jobs, make);
  std::vector<Result> results;
  results.reserve(count);
  for (const std::string& bytes :
       workers.shared(count, jobs, [&](std::size_t i) { return packed<Result>(make(i)); })) {
    results.push_back(unpacked<Result>(bytes));
  }
  return results;
}

}  // namespace roomatlas
