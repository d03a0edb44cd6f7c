// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "console.hpp"
#include "output_places.hpp"
#include "printable.hpp"
#include "roomatlas/core/counted.hpp"
#include "roomatlas/io/files/files.hpp"
#include "roomatlas/io/trajectories/pose_graph_file.hpp"
#include "roomatlas/solve/optimize.hpp"

namespace roomatlas::apps {
namespace {

using Json = nlohmann::ordered_json;

std::string id_of(const PoseGraph& graph, std::int32_t node) {
  return std::to_string(graph.ids[static_cast<std::size_t>(node)]);
}

Json issues_as_json(const Issues& issues) {
  Json list = Json::array();
  for (const Issue& issue : issues) {
    const char* severity = issue.severity == Severity::note ? "note" : "warning";
    list.push_back({{"severity", severity}, {"message", to_string(issue)}});
  }
  return list;
}

Json closures_as_json(const PoseGraph& graph, const OptimizeResult& result) {
  Json closures = Json::array();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e].kind == EdgeKind::odometry) continue;
    const EdgeVerdict& verdict = result.edges[e];
    closures.push_back({{"from", graph.ids[static_cast<std::size_t>(graph.edges[e].from)]},
                        {"to", graph.ids[static_cast<std::size_t>(graph.edges[e].to)]},
                        {"weight", verdict.weight},
                        {"chi_square", verdict.chi_square},
                        {"accepted", verdict.accepted},
                        {"reason", words(verdict)}});
  }
  return closures;
}

std::ptrdiff_t count_loops(const PoseGraph& graph) {
  return std::ranges::count_if(graph.edges,
                               [](const PoseEdge& e) { return e.kind != EdgeKind::odometry; });
}

std::ptrdiff_t count_rejected(const OptimizeResult& result) {
  return std::ranges::count_if(result.edges, [](const EdgeVerdict& v) { return !v.accepted; });
}

Json as_json(const Path& file, const PoseGraphFile& input, const OptimizeResult& result,
             double seconds) {
  Issues issues = input.issues;
  issues.insert(issues.end(), result.issues.begin(), result.issues.end());
  return {{"file", file.filename().string()},
          {"nodes", input.graph.ids.size()},
          {"edges", input.graph.edges.size()},
          {"loops", count_loops(input.graph)},
          {"ignored_lines", input.ignored_lines},
          {"components", result.fixed.size()},
          {"solver", result.message},
          {"converged", result.converged},
          {"trusted", result.trusted},
          {"initial_chi_square", result.initial_chi_square},
          {"chi_square", result.chi_square},
          {"degrees_of_freedom", result.expected.degrees_of_freedom},
          {"expected_chi_square", {result.expected.low, result.expected.high}},
          {"iterations", result.iterations},
          {"seconds", seconds},
          {"rejected", count_rejected(result)},
          {"issues", issues_as_json(issues)},
          {"closures", closures_as_json(input.graph, result)}};
}

/// Notes belong to the answer: they go to stdout, and warnings alone to stderr.
void print_notes(const Issues& issues) {
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::note) say("note: {}\n", to_string(issue));
  }
}

Issues warnings_of(const Issues& issues) {
  Issues warnings;
  std::ranges::copy_if(issues, std::back_inserter(warnings),
                       [](const Issue& issue) { return issue.severity != Severity::note; });
  return warnings;
}

void append_covariance(std::string& text, const std::string& label, const Eigen::Matrix3d& c) {
  text += fmt::format("{},{},{},{},{},{},{}\n", label, c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2),
                      c(2, 2));
}

/// A node relative to the fixed one of its component, an edge's `to` relative to its `from`.
std::string covariance_table(const PoseGraph& graph, const OptimizeResult& result) {
  std::string text = "from,to,xx,xy,xt,yy,yt,tt\n";
  for (std::size_t i = 0; i < graph.ids.size(); ++i) {
    const auto fixed = result.fixed[static_cast<std::size_t>(result.component[i])];
    append_covariance(text, id_of(graph, fixed) + "," + std::to_string(graph.ids[i]),
                      result.covariance.of_node[i]);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    append_covariance(text,
                      id_of(graph, graph.edges[e].from) + "," + id_of(graph, graph.edges[e].to),
                      result.covariance.of_edge[e]);
  }
  return text;
}

OptimizeResult solved(const Path& file, const PoseGraph& graph, const OptimizeOptions& options) {
  try {
    return roomatlas::optimize(graph, options);
  } catch (const NotEnoughError& error) {
    throw NotEnoughError(file.string() + ": " + error.what());
  }
}

}  // namespace

void optimize(const Settings& settings, const OptimizeArguments& arguments) {
  require_output_file(arguments.out, {arguments.graph});
  require_output_files({arguments.out, arguments.covariance}, {arguments.graph});
  const PoseGraphFile input = read_pose_graph(arguments.graph);
  OptimizeOptions options = arguments.options;
  options.covariance = !arguments.covariance.empty();
  const auto start = std::chrono::steady_clock::now();
  const OptimizeResult result = solved(arguments.graph, input.graph, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

  std::vector<std::uint8_t> accepted;
  for (const EdgeVerdict& verdict : result.edges) accepted.push_back(verdict.accepted ? 1 : 0);
  write_g2o(arguments.out, input.graph, result.poses, accepted);
  if (options.covariance) {
    write_file(arguments.covariance, covariance_table(input.graph, result));
  }
  const Issues warnings = warnings_of(result.issues);
  show(warnings);
  if (settings.json) {
    const auto json = as_json(arguments.graph, input, result, elapsed.count());
    fmt::print("{}\n", json.dump(2, ' ', false, decltype(json)::error_handler_t::replace));
  } else {
    say("{}, {}, {}, {}\n", counted(input.graph.ids.size(), "node"),
        counted(input.graph.edges.size(), "edge"),
        counted(count_loops(input.graph), "of them a loop", "of them loops"),
        counted(result.fixed.size(), "component"));
    say("chi-square {:.6f} (before {:.6g}; expected {:.6g} to {:.6g})\n", result.chi_square,
        result.initial_chi_square, result.expected.low, result.expected.high);
    say("{}, {:.4f} s, {} rejected, {}\n", counted(result.iterations, "iteration"), elapsed.count(),
        counted(count_rejected(result), "closure"),
        result.trusted ? "trusted" : "NOT TO BE TRUSTED");
    print_notes(input.issues);
    print_notes(result.issues);
  }
  if (arguments.strict && !result.trusted) {
    throw GateFailed("the result should not be trusted; it is written nevertheless");
  }
}

}  // namespace roomatlas::apps
