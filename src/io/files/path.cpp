// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

Path behind_links(const Path& file) {
  constexpr int kMostLinks = 40;  // as the kernel has it: more are a circle
  std::error_code error;
  Path real = file;
  for (int links = 0; std::filesystem::is_symlink(real, error); ++links) {
    if (links == kMostLinks) return file;
    real = real.parent_path() / std::filesystem::read_symlink(real, error);  // absolute ones stay
    if (error) return file;
  }
  return real;
}

}  // namespace roomatlas
