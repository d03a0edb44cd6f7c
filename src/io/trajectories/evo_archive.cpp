// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/trajectories/evo_archive.hpp"

#include "files/zip_writer.hpp"
#include "text/json.hpp"
#include "tum_text.hpp"

#include <bit>
#include <cmath>

namespace roomatlas {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie");

/// NumPy's array format, version 1.0: a dictionary padded to 64 bytes, then the doubles.
/// @param shape as in Python, such as "(12,)" or "(4, 4)"
std::string npy(const std::vector<double>& values, const std::string& shape) {
  std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }";
  constexpr std::size_t kPrelude = 10;  // bytes: magic word, version, length of the dictionary
  dictionary.append(63 - (kPrelude + dictionary.size()) % 64, ' ');
  dictionary += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += std::string("\x01\x00", 2);
  bytes += static_cast<char>(dictionary.size() & 0xffU);
  bytes += static_cast<char>(dictionary.size() >> 8U);
  bytes += dictionary;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  return bytes;
}

/// The motion in space, as evo keeps it.
std::string npy(const Pose2& pose) {
  const double c = std::cos(pose.theta_rad);
  const double s = std::sin(pose.theta_rad);
  return npy({c, -s, 0, pose.x_m, s, c, 0, pose.y_m, 0, 0, 1, 0, 0, 0, 0, 1}, "(4, 4)");
}

std::string info_json(const EvoResult& result) {
  const Json json = {{"title", result.title},
                     {"ref_name", result.ref_name},
                     {"est_name", result.est_name},
                     {"label", result.label}};
  return compact(json);
}

std::string stats_json(const EvoResult& result) {
  Json json = Json::object();
  for (const auto& [name, value] : named(result.statistics)) json[name] = value;
  return compact(json);
}

}  // namespace

std::string evo_archive(const EvoResult& result) {
  io::ZipWriter archive;
  archive.add("info.json", info_json(result));
  archive.add("stats.json", stats_json(result));
  for (const auto& [name, values] : result.arrays) {
    archive.add(name + ".npy", npy(values, "(" + std::to_string(values.size()) + ",)"));
  }
  if (result.aligned) {
    archive.add("alignment_transformation_sim3.npy", npy(result.truth_from_estimate));
  }
  for (const auto& [name, trajectory] : result.trajectories) {
    archive.add(name + ".tum", io::tum_text(trajectory));
  }
  return archive.finish();
}

}  // namespace roomatlas
