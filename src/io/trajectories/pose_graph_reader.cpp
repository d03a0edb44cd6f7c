// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include "roomatlas/io/trajectories/pose_graph_file.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace roomatlas {
namespace {

constexpr std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

enum class LineKind { vertex, g2o_edge, toro_edge, other };

LineKind kind_of(std::string_view tag) {
  if (tag == "VERTEX_SE2" || tag == "VERTEX2" || tag == "VERTEX") return LineKind::vertex;
  if (tag == "EDGE_SE2") return LineKind::g2o_edge;
  if (tag == "EDGE2" || tag == "EDGE") return LineKind::toro_edge;
  return LineKind::other;
}

/// Where each of the six numbers of an information matrix stands.
struct Entry {
  const char* name;
  int row;
  int column;
};
/// Row by row.
constexpr std::array<Entry, 6> kG2oOrder = {
    {{"I11", 0, 0}, {"I12", 0, 1}, {"I13", 0, 2}, {"I22", 1, 1}, {"I23", 1, 2}, {"I33", 2, 2}}};
/// TORO's own order.
constexpr std::array<Entry, 6> kToroOrder = {
    {{"I11", 0, 0}, {"I12", 0, 1}, {"I22", 1, 1}, {"I33", 2, 2}, {"I13", 0, 2}, {"I23", 1, 2}}};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : name_(file.string()), lines_(file) {}

  PoseGraphFile read() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (lines_.line_is_too_long()) fail("the line is too long");
      Tokens fields(*line);
      const std::string_view tag = fields.next();
      if (tag.empty() || tag.front() == '#') continue;
      read_line(tag, fields);
    }
    if (lines_.end() != io::LineReader::End::complete) {
      fail("the gzip data ends here; copy the file again");
    }
    join_edges();
    report();
    return std::move(result_);
  }

 private:
  using Tokens = io::Tokens;

  [[noreturn]] void fail(const std::string& message) const { fail(lines_.line_number(), message); }
  [[noreturn]] void fail(std::int64_t line, const std::string& message) const {
    throw InputError(name_ + ":" + std::to_string(line) + ": " + message);
  }

  void read_line(std::string_view tag, Tokens fields) {
    const LineKind kind = kind_of(tag);
    if (kind == LineKind::other) {
      ++result_.ignored_lines[std::string(tag)];
      return;
    }
    ++(tag.ends_with("SE2") ? result_.g2o_lines : result_.toro_lines);
    tag_ = tag;
    if (kind == LineKind::vertex) {
      read_vertex(fields);
    } else {
      read_edge(fields, kind == LineKind::g2o_edge ? kG2oOrder : kToroOrder);
    }
  }

  std::int64_t id(Tokens& fields, const char* field) const {
    const std::string_view token = fields.next();
    const std::optional<double> value = io::parse_number(token);
    constexpr double kLargest = 9.0e15;  // what a double counts without gaps
    if (!value || !(std::abs(*value) <= kLargest) || *value != std::floor(*value)) {
      fail(tag_ + ": " + field + ": expected a whole number, found " + io::quoted(token));
    }
    return static_cast<std::int64_t>(*value);
  }

  double number(Tokens& fields, const char* field) const {
    const std::string_view token = fields.next();
    const std::optional<double> value = io::parse_number(token);
    if (!value || !std::isfinite(*value)) {
      fail(tag_ + ": " + field + ": expected a finite number, found " +
           (token.empty() ? "the end of the line" : io::quoted(token)));
    }
    return *value;
  }

  Pose2 pose(Tokens& fields) const {
    const double x_m = number(fields, "x");
    const double y_m = number(fields, "y");
    return {x_m, y_m, wrap_angle(number(fields, "theta"))};
  }

  void read_vertex(Tokens& fields) {
    const std::int64_t vertex = id(fields, "id");
    const auto [known, is_new] = index_.try_emplace(vertex, std::ssize(result_.graph.ids));
    if (!is_new) {
      fail("vertex " + std::to_string(vertex) + " is there twice, first in line " +
           std::to_string(vertex_line_[at(known->second)]) + "; delete one of the lines");
    }
    result_.graph.ids.push_back(vertex);
    vertex_line_.push_back(lines_.line_number());
    result_.graph.guess.push_back(pose(fields));
  }

  void read_edge(Tokens& fields, const std::array<Entry, 6>& order) {
    OpenEdge open;
    open.line = lines_.line_number();
    open.from = id(fields, "from");
    open.to = id(fields, "to");
    PoseEdge edge;
    edge.from_from_to = pose(fields);
    for (const Entry& entry : order) {
      const double value = number(fields, entry.name);
      edge.information(entry.row, entry.column) = value;
      edge.information(entry.column, entry.row) = value;
    }
    if (open.from == open.to) {
      fail("the edge joins vertex " + std::to_string(open.from) +
           " with itself; delete or correct the line");
    }
    if (const std::string problem = problem_of(edge); !problem.empty()) {
      fail("edge from " + std::to_string(open.from) + " to " + std::to_string(open.to) + ": " +
           problem + "; correct or delete the line");
    }
    edge.kind = std::abs(open.to - open.from) == 1 ? EdgeKind::odometry : EdgeKind::loop;
    result_.graph.edges.push_back(edge);
    open_.push_back(open);
  }

  /// Vertices may stand behind the edges that join them.
  void join_edges() {
    const bool has_vertices = !result_.graph.ids.empty();
    const auto node = [&](std::int64_t vertex, std::int64_t line) {
      const auto [known, is_new] = index_.try_emplace(vertex, std::ssize(result_.graph.ids));
      if (is_new && has_vertices) {
        fail(line, "the edge joins vertex " + std::to_string(vertex) +
                       ", which has no line of its own; add it, or leave out all vertices");
      }
      if (is_new) result_.graph.ids.push_back(vertex);
      return static_cast<std::int32_t>(known->second);
    };
    for (std::size_t e = 0; e < open_.size(); ++e) {
      result_.graph.edges[e].from = node(open_[e].from, open_[e].line);
      result_.graph.edges[e].to = node(open_[e].to, open_[e].line);
    }
  }

  void report() {
    if (result_.g2o_lines + result_.toro_lines == 0) {
      throw InputError(name_ +
                       ": no line of a planar pose graph: expected VERTEX_SE2 and EDGE_SE2 (g2o) "
                       "or VERTEX2 and EDGE2 (TORO)");
    }
    for (const auto& [tag, count] : result_.ignored_lines) {
      const std::string lines = std::to_string(count) + (count == 1 ? " line " : " lines ");
      const bool equivalence = tag == "EQUIV";
      const std::string why =
          equivalence ? "not used: two vertices said to be the same place, without a measurement"
                      : "not used: no part of a planar pose graph";
      result_.issues.push_back({Severity::note, name_, 0, tag, lines + why});
    }
  }

  struct OpenEdge {
    std::int64_t from = 0;
    std::int64_t to = 0;
    std::int64_t line = 0;
  };

  std::string name_;
  io::LineReader lines_;
  std::string tag_;
  std::unordered_map<std::int64_t, std::int64_t> index_;  ///< of each vertex
  std::vector<std::int64_t> vertex_line_;
  std::vector<OpenEdge> open_;
  PoseGraphFile result_;
};

}  // namespace

PoseGraphFile read_pose_graph(const std::filesystem::path& file) { return Reader(file).read(); }

}  // namespace roomatlas
