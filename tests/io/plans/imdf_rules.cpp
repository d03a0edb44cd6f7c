// SPDX-License-Identifier: GPL-3.0-or-later
#include "imdf_rules.hpp"

#include <algorithm>
#include <cstdint>
#include <regex>
#include <set>

#include "imdf_places.hpp"
#include "imdf_types.hpp"

namespace roomatlas::test {
namespace {

using Json = nlohmann::json;
using namespace imdf;

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
  }
  return value;
}

bool is_uuid(const Json& value) {
  static const std::regex form(
      "[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}");
  return value.is_string() && std::regex_match(value.get<std::string>(), form);
}

class Rules {
 public:
  explicit Rules(const ImdfFiles& files) : files_(files) {
    for (const auto& [name, content] : files) {
      if (name != "manifest.json") read_collection(name, content);
    }
  }

  std::vector<std::string> broken() {
    check_manifest();
    for (const char* needed : {"address", "venue", "building", "footprint", "level", "unit"}) {
      require(!imdf_features(files_, needed).empty(), std::string("there is no ") + needed);
    }
    for (const Json& feature : features_) check(feature);
    check_imdf_places(files_, broken_);
    return broken_;
  }

 private:
  void require(bool holds, const std::string& sentence) {
    if (!holds) broken_.push_back(sentence);
  }

  void read_collection(const std::string& name, const Json& content) {
    const std::string type = name.substr(0, name.rfind(".geojson"));
    require(name.ends_with(".geojson") && types().contains(type), name + " is no type's file");
    require(content.value("type", "") == "FeatureCollection", name + " is no FeatureCollection");
    for (const Json& feature : content["features"]) {
      require(feature.value("feature_type", "") == type, name + " holds another type");
      require(is_uuid(feature["id"]), name + ": an id is no UUID of version 4");
      const std::string id = feature["id"];
      require(type_of_.emplace(id, type).second, name + ": id " + id + " stands twice");
      features_.push_back(feature);
    }
  }

  void check_manifest() {
    if (!files_.contains("manifest.json")) return require(false, "there is no manifest");
    const Json& manifest = files_.at("manifest.json");
    require(manifest.value("version", "") == "1.0.0", "the manifest's version is not 1.0.0");
    static const std::regex time(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(Z|[+-]\d\d:\d\d))");
    require(std::regex_match(manifest.value("created", ""), time), "created is no date-time");
    language_ = manifest.value("language", "");
    require(!language_.empty(), "the manifest has no language");
  }

  void check(const Json& feature) {
    const std::string type = feature["feature_type"];
    const Type& rules = types().at(type);
    const std::string name = type + " " + feature["id"].get<std::string>();
    require(feature.value("type", "") == "Feature", name + " is no Feature");
    const Json& geometry = feature.at("geometry");
    if (rules.geometries.empty()) {
      require(geometry.is_null(), name + " has a geometry");
    } else {
      const std::string kind = geometry.is_object() ? geometry.value("type", "") : "null";
      require(rules.geometries.contains(kind), name + " has a geometry of type " + kind);
    }
    const Json& properties = feature.at("properties");
    for (const auto& [key, kind] : rules.keys) {
      if (!properties.contains(key)) {
        require(false, name + " lacks " + key);
      } else {
        require(is(kind, properties[key], rules),
                name + ": " + key + " is " + properties[key].dump());
      }
    }
    for (const auto& [key, value] : properties.items()) {
      require(rules.keys.contains(key), name + " has " + key);
      if (key.ends_with("_id") && value.is_string())
        refer(name, value, key.substr(0, key.size() - 3));
      if (key.ends_with("_ids") && value.is_array()) {
        for (const Json& one : value) refer(name, one, key.substr(0, key.size() - 4));
      }
      if (key == "country") {
        require(std::regex_match(value.get<std::string>(), std::regex("[A-Z]{2}")),
                name + ": country is no code");
      }
    }
  }

  void refer(const std::string& from, const Json& id, const std::string& type) {
    const auto found = type_of_.find(id.is_string() ? id.get<std::string>() : "");
    require(found != type_of_.end() && found->second == type, from + " names no " + type);
  }

  bool is_reference(const Json& value) {
    if (!value.is_object()) return false;
    refer("a relationship", value.value("id", ""), value.value("feature_type", ""));
    return value.size() == 2;
  }
  bool is_labels(const Json& value) const {
    if (!value.is_object() || !value.contains(language_)) return false;
    return std::all_of(value.begin(), value.end(), [](const Json& one) {
      return one.is_string() && !one.get<std::string>().empty();
    });
  }
  static bool is_point(const Json& value) {
    return value.is_object() && value.value("type", "") == "Point" &&
           value["coordinates"].size() == 2;
  }

  bool is(Kind kind, const Json& value, const Type& rules) {
    const bool is_null = value.is_null();
    switch (kind) {
      case Kind::text:
        return value.is_string() && !value.get<std::string>().empty();
      case Kind::text_or_null:
        return is_null || (value.is_string() && !value.get<std::string>().empty());
      case Kind::labels:
        return is_labels(value);
      case Kind::labels_or_null:
        return is_null || is_labels(value);
      case Kind::point:
        return is_point(value);
      case Kind::point_or_null:
        return is_null || is_point(value);
      case Kind::id:
        return is_uuid(value);
      case Kind::id_or_null:
        return is_null || is_uuid(value);
      case Kind::ids:
        return value.is_array() && !value.empty();
      case Kind::ids_or_null:
        return is_null || (value.is_array() && !value.empty());
      case Kind::truth:
        return value.is_boolean();
      case Kind::whole:
        return value.is_number_integer();
      case Kind::category:
        return value.is_string() && rules.categories.contains(value.get<std::string>());
      case Kind::null_or_list:
        return is_null || value.is_array();
      case Kind::door_or_null:
        return is_null || (value.is_object() && value.value("type", "") == "swinging");
      case Kind::reference_or_null:
        return is_null || is_reference(value);
      case Kind::references_or_null:
        return is_null || (value.is_array() && !value.empty() &&
                           std::all_of(value.begin(), value.end(),
                                       [&](const Json& one) { return is_reference(one); }));
    }
    return false;
  }

  const ImdfFiles& files_;
  std::vector<Json> features_;
  std::map<std::string, std::string> type_of_;
  std::string language_;
  std::vector<std::string> broken_;
};

}  // namespace

std::map<std::string, std::string> unzipped(const std::string& zip) {
  std::map<std::string, std::string> files;
  for (std::size_t at = 0; number_at(zip, at, 4) == 0x04034b50U;) {
    const std::size_t size = number_at(zip, at + 22, 4);
    const std::size_t name = number_at(zip, at + 26, 2);
    const std::size_t extra = number_at(zip, at + 28, 2);
    const std::size_t content = at + 30 + name + extra;
    files[zip.substr(at + 30, name)] = zip.substr(content, size);
    at = content + size;
  }
  return files;
}

ImdfFiles imdf_files(const std::string& zip) {
  ImdfFiles files;
  for (const auto& [name, content] : unzipped(zip)) files[name] = Json::parse(content);
  return files;
}

std::vector<Json> imdf_features(const ImdfFiles& files, const std::string& type) {
  const auto found = files.find(type + ".geojson");
  if (found == files.end()) return {};
  return found->second["features"].get<std::vector<Json>>();
}

std::vector<std::string> broken_imdf_rules(const ImdfFiles& files) { return Rules(files).broken(); }

}  // namespace roomatlas::test
