// SPDX-License-Identifier: GPL-3.0-or-later
#include "bags/frame_tree.hpp"

#include <algorithm>
#include <limits>

namespace roomatlas::io {
namespace {

constexpr std::size_t kDeepest = 64;  // edges above a frame; more are a ring

}  // namespace

void FrameTree::add(const TransformsMessage& message, bool is_fixed) {
  for (const PoseMessage& transform : message) {
    (void)add(transform, transform.header.stamp_ns, is_fixed);
  }
}

TransformTrack::Added FrameTree::add(const PoseMessage& transform, std::int64_t stamp_ns,
                                     bool is_fixed) {
  using Added = TransformTrack::Added;
  const std::string& parent = transform.header.frame;
  const std::string& child = transform.child_frame;
  const auto known = nodes_.find(child);
  const bool full = known == nodes_.end() && nodes_.size() >= kMostFrames;
  if (!transform.frame_from_child || parent.empty() || child.empty() || parent == child || full) {
    ++unsound_;
    return Added::in_order;
  }
  Node& node = known != nodes_.end() ? known->second : nodes_[child];
  if (node.edge.parent != parent) {
    if (!node.edge.parent.empty()) ++parents_changed_;
    node = {};
    node.edge.parent = parent;
    node.edge.child = child;
  }
  const bool first = node.edge.transforms++ == 0;
  node.edge.is_fixed = is_fixed;
  if (is_fixed) {
    node.edge.moves =
        node.edge.moves || (!first && !is_same(node.fixed, *transform.frame_from_child));
    node.fixed = *transform.frame_from_child;
    return Added::in_order;
  }
  const Added added = node.track.add(stamp_ns, *transform.frame_from_child);
  node.edge.moves = node.edge.moves || !node.track.is_constant();
  return added;
}

void FrameTree::add_fixed_of(const FrameTree& other) {
  for (const auto& [child, node] : other.nodes_) {
    if (node.edge.is_fixed) nodes_.insert_or_assign(child, node);
  }
}

const FrameTree::Node* FrameTree::node(const std::string& frame) const {
  const auto found = nodes_.find(frame);
  return found == nodes_.end() ? nullptr : &found->second;
}

std::vector<const FrameTree::Node*> FrameTree::chain(const std::string& frame) const {
  std::vector<const Node*> nodes;
  for (const Node* at = node(frame); at != nullptr && nodes.size() < kDeepest;
       at = node(at->edge.parent)) {
    nodes.push_back(at);
  }
  return nodes;
}

std::optional<TransformAt> FrameTree::lookup(const std::string& target, const std::string& source,
                                             std::int64_t stamp_ns, Constant constant) const {
  std::vector<const Node*> up = chain(source);
  std::vector<const Node*> down = chain(target);
  const auto root = [](const std::vector<const Node*>& nodes, const std::string& frame) {
    return nodes.empty() ? frame : nodes.back()->edge.parent;
  };
  if (root(up, source) != root(down, target)) return std::nullopt;
  while (!up.empty() && !down.empty() && up.back() == down.back()) {
    up.pop_back();
    down.pop_back();
  }
  std::int64_t beyond_ns = 0;
  const auto climb = [&](const std::vector<const Node*>& nodes) {
    Transform3 top_from_frame;
    for (const Node* at : nodes) {  // a single edge is told as it is, without a rounding
      Transform3 parent_from_child = at->fixed;
      if (!at->edge.is_fixed) {
        const TransformAt found = *at->track.at(stamp_ns);  // an edge has a sample
        parent_from_child = found.transform;
        const bool is_mount = constant == Constant::holds_always && at->track.is_constant();
        if (!is_mount) beyond_ns = std::max(beyond_ns, found.beyond_ns);
      }
      top_from_frame = at == nodes.front() ? parent_from_child : parent_from_child * top_from_frame;
    }
    return top_from_frame;
  };
  const Transform3 top_from_source = climb(up);
  if (down.empty()) return TransformAt{top_from_source, beyond_ns};
  const Transform3 top_from_target = climb(down);
  return TransformAt{inverse(top_from_target) * top_from_source, beyond_ns};
}

std::optional<Transform3> FrameTree::newest(const std::string& target,
                                            const std::string& source) const {
  constexpr std::int64_t kEndOfTime_ns = std::numeric_limits<std::int64_t>::max();
  const auto found = lookup(target, source, kEndOfTime_ns, Constant::holds_always);
  if (!found) return std::nullopt;
  return found->transform;
}

bool FrameTree::are_joined(const std::string& one, const std::string& other) const {
  return lookup(one, other, 0, Constant::holds_always).has_value();
}

bool FrameTree::knows(const std::string& frame) const {
  return node(frame) != nullptr ||
         std::any_of(nodes_.begin(), nodes_.end(),
                     [&](const auto& entry) { return entry.second.edge.parent == frame; });
}

std::vector<FrameEdge> FrameTree::edges_above(const std::string& frame) const {
  std::vector<FrameEdge> edges;
  for (const Node* at : chain(frame)) edges.push_back(at->edge);
  return edges;
}

std::vector<FrameEdge> FrameTree::edges() const {
  std::vector<FrameEdge> edges;
  for (const auto& entry : nodes_) edges.push_back(entry.second.edge);
  return edges;
}

}  // namespace roomatlas::io
