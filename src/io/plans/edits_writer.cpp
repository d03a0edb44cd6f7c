// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "edits_schema.hpp"
#include "geojson_geometry.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "text/json.hpp"

namespace roomatlas {
namespace {

Json json_of(const Ring& ring) {
  Json json = Json::array();
  for (const Point2& point : ring) json.push_back(to_json(point));
  return json;
}

Json json_of(const RoomAnchor& anchor) {
  Json json = Json::object();
  if (anchor.id) json["id"] = *anchor.id;
  if (anchor.at) json["at_m"] = to_json(*anchor.at);
  if (!anchor.outline.empty()) json["outline_m"] = json_of(anchor.outline);
  return json;
}

Json value_of(const Edit& edit, const std::string& field) {
  if (field == "room") return json_of(edit.rooms.at(0));
  if (field == "rooms") return {json_of(edit.rooms.at(0)), json_of(edit.rooms.at(1))};
  if (field == "name") return edit.name;
  if (field == "kind") return to_string(edit.room_kind);
  if (field == edits_schema::line_field(edit.kind)) {
    return {to_json(edit.line.a), to_json(edit.line.b)};
  }
  if (field == "at_m") return to_json(edit.at);
  if (field == "outline_m") return edit.outline.empty() ? Json() : json_of(edit.outline);
  if (field == "by_m") return edit.by_m;
  if (field == "thickness_m") return edit.thickness_m > 0.0 ? Json(edit.thickness_m) : Json();
  if (field == "from_time_s") return edit.from_time_s;
  if (field == "to_time_s") return edit.to_time_s;
  return {{"x_m", edit.from_from_to.x_m},
          {"y_m", edit.from_from_to.y_m},
          {"theta_rad", edit.from_from_to.theta_rad}};
}

Json json_of(const Edit& edit) {
  const auto& all = edits_schema::statements();
  const auto statement =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.kind == edit.kind; });
  Json json = {{"edit", to_string(edit.kind)}};
  for (const std::string& field : statement->fields) {
    Json value = value_of(edit, field);
    if (!value.is_null()) json[field] = std::move(value);
  }
  return json;
}

}  // namespace

std::string edits_json(const std::vector<Edit>& edits) {
  Json header = {{"format", edits_schema::kFormat},
                 {"version", edits_schema::kVersion},
                 {"frame", "building"}};
  std::string text = header.dump(1);
  text.erase(text.size() - 2);  // a statement a line, so that people can read and compare them
  text += ",\n \"edits\": [";
  for (std::size_t i = 0; i < edits.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + json_of(edits[i]).dump();
  }
  return text + (edits.empty() ? "]\n}\n" : "\n ]\n}\n");
}

}  // namespace roomatlas
