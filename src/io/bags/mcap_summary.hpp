// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mcap_records.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace roomatlas::io {

/// A chunk as the index at the file's end has it.
struct McapIndexedChunk {
  Chunk chunk;            ///< its content is not known yet
  std::uint64_t end = 0;  ///< where what is behind it and its message indexes begins
};

/// The summary at an MCAP file's end, as far as there is one.
struct McapSummary {
  bool is_closed = false;      ///< the file ends as it should
  std::uint64_t data_end = 0;  ///< where the summary, or else the footer or the file's end begins
  std::string damage;          ///< why the summary is not used; empty where all is well
  std::vector<McapChannel> channels;                 ///< those whose schemas are there too
  bool has_all_channels = false;                     ///< as far as can be seen
  std::map<std::uint64_t, McapIndexedChunk> chunks;  ///< by the offset of their records
  std::optional<std::map<std::uint16_t, std::uint64_t>> messages;  ///< of each channel
};

/// Reads footer and summary. A summary with a wrong CRC is not used. Schemas are added to
/// `schemas`.
[[nodiscard]] McapSummary read_mcap_summary(BagFile& file, McapSchemas& schemas);

}  // namespace roomatlas::io
