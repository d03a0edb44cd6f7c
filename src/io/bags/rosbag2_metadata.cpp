// SPDX-License-Identifier: GPL-3.0-or-later
#include "rosbag2_metadata.hpp"

#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "topic_table.hpp"

namespace roomatlas::io {
namespace {

/// A line of YAML: how far it is indented, whether it begins an item, its key and its value.
struct YamlLine {
  std::size_t indent = 0;
  bool is_item = false;
  std::string_view key;
  std::string value;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  const bool is_quoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'');
  if (!is_quoted || text.back() != text[0]) return std::string(text);
  return std::string(text.substr(1, text.size() - 2));
}

YamlLine parse(std::string_view line) {
  YamlLine parsed;
  parsed.indent = std::min(line.find_first_not_of(' '), line.size());
  line = trimmed(line);
  if (line.starts_with("- ")) {
    parsed.is_item = true;
    line = trimmed(line.substr(2));
  }
  // A name is quoted where it has a colon in it.
  const bool is_quoted = line.starts_with('"') || line.starts_with('\'');
  const std::size_t colon = is_quoted ? std::string_view::npos : line.find(": ");
  if (colon != std::string_view::npos) {
    parsed.key = line.substr(0, colon);
    parsed.value = unquoted(line.substr(colon + 2));
  } else if (!is_quoted && line.ends_with(':')) {
    parsed.key = line.substr(0, line.size() - 1);
  } else {
    parsed.value = unquoted(line);
  }
  return parsed;
}

/// `[a, b]` on one line.
void add_flow_items(std::string_view list, std::vector<std::string>& items) {
  if (!list.starts_with('[') || !list.ends_with(']')) return;
  list = list.substr(1, list.size() - 2);
  while (!trimmed(list).empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    items.push_back(unquoted(list.substr(0, comma)));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
}

class Reader {
 public:
  void take(const YamlLine& line) {
    if (in_files_ && line.is_item && line.key.empty()) {
      metadata.files.push_back(line.value);
      return;
    }
    if (!line.key.empty()) in_files_ = false;
    if (line.key == "rosbag2_bagfile_information") is_rosbag2 = true;
    if (line.key == "relative_file_paths") {
      in_files_ = true;
      add_flow_items(line.value, metadata.files);
    }
    if (line.key == "compression_format") metadata.compression_format = line.value;
    if (line.key == "topic_metadata") {
      metadata.topics.emplace_back();
      topic_indent_ = line.indent;
    }
    if (!metadata.topics.empty()) take_topic_field(line, metadata.topics.back());
  }

  Rosbag2Metadata metadata;
  bool is_rosbag2 = false;

 private:
  void take_topic_field(const YamlLine& line, BagTopic& topic) const {
    if (line.indent <= topic_indent_) return;
    if (line.key == "name" && topic.name.empty()) topic.name = line.value;
    if (line.key == "type" && topic.type.empty()) topic.type = plain_type(line.value);
    if (line.key == "serialization_format") topic.encoding = bag_encoding_of(line.value);
    if (line.key == "message_count" && !topic.messages) {
      const auto count = parse_number(line.value);
      if (count && *count >= 0 && *count < 1e15) topic.messages = static_cast<std::int64_t>(*count);
    }
  }

  bool in_files_ = false;
  std::size_t topic_indent_ = 0;
};

}  // namespace

std::optional<Rosbag2Metadata> read_rosbag2_metadata(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kRosbag2MetadataName;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  Reader reader;
  try {
    LineReader lines(file);
    while (const auto line = lines.next()) reader.take(parse(*line));
  } catch (const InputError&) {
    return std::nullopt;  // empty, or no text: the recording's files are there all the same
  }
  if (!reader.is_rosbag2) return std::nullopt;
  return reader.metadata;
}

}  // namespace roomatlas::io
