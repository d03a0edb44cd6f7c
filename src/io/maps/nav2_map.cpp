// SPDX-License-Identifier: GPL-3.0-or-later
#include "nav2_map.hpp"

#include "files/place_inside.hpp"
#include "text/line_reader.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

#include <cmath>
#include <map>

namespace roomatlas::io {
namespace {

struct Value {
  std::string text;
  std::int64_t line = 0;
};

/// The `key: value` lines of a YAML file, one level deep. A list may stand in brackets or as
/// `- item` lines behind its key; either way its items are parted by blanks here.
class FlatYaml {
 public:
  explicit FlatYaml(const std::filesystem::path& file) : file_(file.string()) {
    LineReader reader(file);
    std::string key;
    while (const auto line = reader.next()) add(without_comment(*line), reader.line_number(), key);
  }

  [[nodiscard]] const Value* find(const std::string& key) const {
    const auto entry = values_.find(key);
    return entry == values_.end() ? nullptr : &entry->second;
  }

  const Value& at(const std::string& key, const std::string& expected) const {
    const Value* value = find(key);
    if (value == nullptr) {
      throw InputError(file_ + ": " + key + ": is missing; expected " + expected);
    }
    return *value;
  }

  std::vector<double> numbers(const std::string& key, std::size_t count,
                              const std::string& expected) const {
    const Value& value = at(key, expected);
    std::vector<double> numbers;
    for (Tokens tokens(value.text); !tokens.at_end();) {
      const auto number = parse_number(tokens.next());
      if (!number || !std::isfinite(*number)) fail(key, value, expected);
      numbers.push_back(*number);
    }
    if (numbers.size() != count) fail(key, value, expected);
    return numbers;
  }

  [[noreturn]] void fail(const std::string& key, const Value& value,
                         const std::string& expected) const {
    throw InputError(file_ + ":" + std::to_string(value.line) + ": " + key + ": expected " +
                     expected + ", found " + io::quoted(value.text));
  }

 private:
  static std::string without_comment(std::string_view line) {
    std::size_t end = line.find('#');
    while (end != std::string_view::npos && end > 0 && line[end - 1] != ' ' &&
           line[end - 1] != '\t') {
      end = line.find('#', end + 1);  // YAML: a comment stands behind a blank
    }
    return std::string(line.substr(0, end));
  }

  static std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
  }

  static std::string plain(std::string text) {
    text = trimmed(text);
    if (text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0]) {
      return text.substr(1, text.size() - 2);
    }
    if (text.starts_with('[')) {
      for (char& c : text) {
        if (c == '[' || c == ']' || c == ',') c = ' ';
      }
    }
    return trimmed(text);
  }

  void add(const std::string& line, std::int64_t number, std::string& key) {
    const std::string text = trimmed(line);
    if (text.starts_with("- ") && !key.empty()) {
      values_[key].text += (values_[key].text.empty() ? "" : " ") + plain(text.substr(2));
      return;
    }
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || text.starts_with("---")) return;
    key = trimmed(text.substr(0, colon));
    values_[key] = {plain(text.substr(colon + 1)), number};
  }

  std::string file_;
  std::map<std::string, Value> values_;
};

double threshold(const FlatYaml& yaml, const std::string& key, double otherwise) {
  if (yaml.find(key) == nullptr) return otherwise;
  const char* expected = "a share from 0 to 1";
  const double value = yaml.numbers(key, 1, expected)[0];
  if (value < 0.0 || value > 1.0) yaml.fail(key, *yaml.find(key), expected);
  return value;
}

bool read_negate(const FlatYaml& yaml) {
  const Value* value = yaml.find("negate");
  if (value == nullptr || value->text == "0" || value->text == "false") return false;
  if (value->text != "1" && value->text != "true") yaml.fail("negate", *value, "0 or 1");
  return true;
}

MapMode read_mode(const FlatYaml& yaml) {
  const Value* value = yaml.find("mode");
  if (value == nullptr || value->text == "trinary") return MapMode::trinary;
  if (value->text == "scale") return MapMode::scale;
  if (value->text == "raw") return MapMode::raw;
  yaml.fail("mode", *value, "trinary, scale or raw: save the map again in one of these modes");
}

/// The picture that the file names, or the same packed, in its folder or below.
std::filesystem::path picture_of(const std::filesystem::path& file, const std::string& image) {
  std::filesystem::path picture = place_inside(file.parent_path(), image);
  std::error_code error;
  if (std::filesystem::is_regular_file(picture, error)) return picture;
  const std::filesystem::path packed = picture.string() + ".gz";
  return std::filesystem::is_regular_file(packed, error) ? packed : picture;
}

}  // namespace

Nav2Map read_nav2_map(const std::filesystem::path& file) {
  const FlatYaml yaml(file);
  Nav2Map map;
  const Value& image = yaml.at("image", "the name of the picture");
  map.picture = picture_of(file, image.text);
  std::error_code error;
  if (!std::filesystem::is_regular_file(map.picture, error)) {
    yaml.fail("image", image,
              "the name of a picture beside this file or below (there is no " +
                  map.picture.string() +
                  ", nor the same with .gz; names that lead elsewhere are not followed): put it "
                  "there, or correct the name");
  }
  const char* metres = "metres a pixel, from 0.001 to 10";
  OccupancyScale& scale = map.scale;
  scale.resolution_m = yaml.numbers("resolution", 1, metres)[0];
  if (scale.resolution_m < 0.001 || scale.resolution_m > 10.0) {
    yaml.fail("resolution", *yaml.find("resolution"), metres);
  }
  const auto origin = yaml.numbers("origin", 3, "[x, y, yaw] of the lower left corner");
  scale.world_from_picture = {origin[0], origin[1], wrap_angle(origin[2])};
  scale.negate = read_negate(yaml);
  scale.occupied_threshold = threshold(yaml, "occupied_thresh", scale.occupied_threshold);
  scale.free_threshold = threshold(yaml, "free_thresh", scale.free_threshold);
  if (scale.free_threshold > scale.occupied_threshold) {
    const bool is_free_given = yaml.find("free_thresh") != nullptr;
    const char* at_fault = is_free_given ? "free_thresh" : "occupied_thresh";
    yaml.fail(at_fault, *yaml.find(at_fault),
              is_free_given ? "at most occupied_thresh" : "at least free_thresh, which is 0.196");
  }
  scale.mode = read_mode(yaml);
  return map;
}

}  // namespace roomatlas::io
