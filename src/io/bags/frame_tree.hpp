// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bags/messages.hpp"
#include "bags/transform_track.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// One edge of the tree of frames.
struct FrameEdge {
  std::string parent;
  std::string child;
  bool is_fixed = false;  ///< latched (/tf_static)
  std::int64_t transforms = 0;
  bool moves = false;  ///< not all of its transforms were the same
};

/// How a lookup treats an edge whose transforms were all the same so far.
enum class Constant {
  holds_always,  ///< it is a mount: known for all times once it was told
  in_its_times,  ///< it is a robot that stood until now
};

/// The tree of coordinate frames as /tf and /tf_static tell it, with the last seconds of what
/// moves.
class FrameTree {
 public:
  static constexpr std::size_t kMostFrames = 10'000;

  /// Frames are named without a leading '/'. What cannot be a transform is left out and counted.
  void add(const TransformsMessage& message, bool is_fixed);
  /// One transform; its stamp is `stamp_ns`, whatever its header says.
  TransformTrack::Added add(const PoseMessage& transform, std::int64_t stamp_ns, bool is_fixed);
  /// Takes over what another tree knows to be fixed.
  void add_fixed_of(const FrameTree& other);

  /// The transform at a time, by the chain over the nearest frame above both; `beyond_ns` is the
  /// worst on the way. Nothing where no chain joins them.
  [[nodiscard]] std::optional<TransformAt> lookup(const std::string& target,
                                                  const std::string& source, std::int64_t stamp_ns,
                                                  Constant constant) const;
  /// The transform that was told last, whatever its stamp: frames of a localizer on another
  /// computer may go by another clock.
  [[nodiscard]] std::optional<Transform3> newest(const std::string& target,
                                                 const std::string& source) const;
  [[nodiscard]] bool are_joined(const std::string& one, const std::string& other) const;
  [[nodiscard]] bool knows(const std::string& frame) const;
  /// From a frame up to the root: each edge's parent is the next one's child.
  [[nodiscard]] std::vector<FrameEdge> edges_above(const std::string& frame) const;
  [[nodiscard]] std::vector<FrameEdge> edges() const;  ///< by name of the child

  [[nodiscard]] std::int64_t unsound() const { return unsound_; }
  [[nodiscard]] std::int64_t parents_changed() const { return parents_changed_; }

 private:
  struct Node {
    FrameEdge edge;
    Transform3 fixed;      ///< parent from child, of a fixed one
    TransformTrack track;  ///< of any other
  };
  [[nodiscard]] const Node* node(const std::string& frame) const;
  [[nodiscard]] std::vector<const Node*> chain(const std::string& frame) const;

  std::map<std::string, Node, std::less<>> nodes_;  ///< by the child's name
  std::int64_t unsound_ = 0;
  std::int64_t parents_changed_ = 0;
};

}  // namespace roomatlas::io
