// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bag_file.hpp"
#include "bag_reader.hpp"

#include <memory>

namespace roomatlas::io {

/// Reads an MCAP file: by its summary, or where there is none, or a damaged one, by a pass over the
/// headers of its records. Throws InputError where no record is whole. CRCs are checked of the
/// summary, of each chunk that is unpacked, and of the data section in files of up to 64 MiB: of
/// larger ones not all is read.
[[nodiscard]] std::unique_ptr<BagReader> open_mcap(std::unique_ptr<BagFile> file);

}  // namespace roomatlas::io
