// SPDX-License-Identifier: GPL-3.0-or-later
// Maps: PGM and PNG, plain and gzip, the YAML files beside them, pictures of room numbers.
#include <fstream>

#include "large.hpp"
#include "roomatlas/io/maps/label_plan.hpp"
#include "roomatlas/io/maps/read_map.hpp"
#include "roomatlas/io/maps/read_world.hpp"
#include "roomatlas/io/pictures/svg_pictures.hpp"
#include "target.hpp"

namespace roomatlas::fuzz {
namespace {

constexpr const char* kText =
    "P2 # a comment\n6 5 255\n0 0 0 0 0 0\n0 254 254 254 254 0\n0 254 205 3 254 0\n"
    "0 254 254 254 254 0\n0 0 0 0 0 0\n";

std::string binary() {
  std::string bytes = "P5\n6 5\n255\n";
  for (int i = 0; i < 30; ++i) bytes += static_cast<char>(i % 7 == 0 ? 0 : 254);
  return bytes;
}

std::vector<std::string> picture_seeds() {
  const std::string png = written("map.png", [](const Path& file) {
    write_png(file,
              "<svg xmlns='http://www.w3.org/2000/svg' width='8' height='8'><rect x='2' y='2' "
              "width='4' height='3' fill='black'/></svg>",
              96.0);
  });
  return {kText, binary(), "P5 2 2 65535\n" + std::string("\1\2\3\4\5\6\7\x08"), png};
}

void read_picture(const Path& file, const std::string&) {
  (void)is_map(file);
  (void)read_map(file, 0.05);
  (void)read_world(file, {0.05, {}});
}

void read_described(const Path& file, const std::string&) {
  static bool is_there = false;
  if (!is_there) std::ofstream(file.parent_path() / "row.pgm", std::ios::binary) << kText;
  is_there = true;
  (void)read_map(file, 0.0);
  (void)read_world(file, {});
}

std::vector<std::string> description_seeds() {
  return {
      "image: row.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmode: trinary\n",
      "---\nimage: \"row.pgm\" # beside it\nresolution: 0.05\norigin:\n  - -1.5\n  - 2\n  - 0.1\n"
      "mode: scale\nnegate: true\n",
      "image: ../row.pgm\nresolution: 1\norigin: [0,0,0]\nmode: raw\n"};
}

}  // namespace

std::vector<Target> picture_targets() {
  return {{"pictures", "map.pgm", picture_seeds, read_picture, large_pictures},
          {"map_descriptions", "map.yaml", description_seeds, read_described},
          {"label_pictures", "labels.pgm", picture_seeds,
           [](const Path& file, const std::string&) { (void)read_label_plan(file, 0.05); },
           large_pictures}};
}

}  // namespace roomatlas::fuzz
