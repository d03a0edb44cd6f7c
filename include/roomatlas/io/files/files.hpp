// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "roomatlas/io/files/path.hpp"

namespace roomatlas {

/// Writes to a temporary name beside `file` and renames it.
void write_file(const Path& file, const std::string& content);

/// An empty file in the place of another of that name, with the permissions of `model` and writable
/// by its owner; nobody else could read it before. Throws InputError where it cannot be made.
void create_like(const Path& file, const Path& model);
/// The permissions alone, for a file that is there.
void give_permissions_of(const Path& model, const Path& file);

/// A log itself, or the files that a recording's folder is made of, by name: what else lies there,
/// such as the plan that was made of it, does not count. Throws InputError for a folder without
/// any.
[[nodiscard]] std::vector<Path> files_of_log(const Path& log);

/// SHA-256 of a file's bytes, in hexadecimal; of what was packed, where it is gzip and whole, so
/// that a log is the same log before and after `gzip`; of a recording's folder, of its files
/// (metadata and storage, in the order of their names), each with name and size before it.
[[nodiscard]] std::string sha256_of_file(const Path& file);

}  // namespace roomatlas
