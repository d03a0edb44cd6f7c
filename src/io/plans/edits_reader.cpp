// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "edits_schema.hpp"
#include "roomatlas/core/issue.hpp"
#include "roomatlas/io/files/input_file.hpp"
#include "roomatlas/io/plans/edits_file.hpp"
#include "text/json.hpp"
#include "text/json_field.hpp"
#include "text/nearest_name.hpp"
#include "text/parse_json.hpp"

namespace roomatlas {
namespace {

constexpr double kShortest_m = 0.05;  // of a line: shorter has no direction
constexpr double kFarthest_m = 1e7;   // from the building's origin, as far as logs may lie
constexpr double kThickest_m = 2.0;

/// Fails on a member that is none of these: a misspelt one would be dropped otherwise.
void require_known(const Json& object, const JsonField& field,
                   const std::vector<std::string>& known) {
  for (const auto& member : object.items()) {
    if (std::find(known.begin(), known.end(), member.key()) != known.end()) continue;
    field.at(member.key())
        .fail("no such field; the nearest is \"" + io::nearest_name(member.key(), known) + "\"");
  }
}

Point2 point_of(const JsonField& field) {
  if (field.size() != 2) field.fail("two numbers, [x, y] in metres");
  Point2 point(field.element(0).number(), field.element(1).number());
  if (point.cwiseAbs().maxCoeff() > kFarthest_m) field.fail("metres, at most 10000000");
  return point;
}

Segment2 line_of(const JsonField& field) {
  if (field.size() != 2) field.fail("two points, [[x, y], [x, y]] in metres");
  Segment2 line{point_of(field.element(0)), point_of(field.element(1))};
  if ((line.b - line.a).norm() < kShortest_m)
    field.fail("two points that are 0.05 m apart or more");
  return line;
}

Ring ring_of(const JsonField& field) {
  Ring ring;
  for (std::size_t i = 0; i < field.size(); ++i) ring.push_back(point_of(field.element(i)));
  if (ring.size() < 3) field.fail("three points or more");
  return ring;
}

RoomAnchor anchor_of(const Json& json, const JsonField& field) {
  RoomAnchor anchor;
  if (!json.is_object()) field.fail("an object with at_m, id or both");
  require_known(json, field, {"id", "at_m", "outline_m"});
  if (const auto id = field.find("id")) anchor.id = id->positive_integer();
  if (const auto at = field.find("at_m")) anchor.at = point_of(*at);
  if (const auto outline = field.find("outline_m")) anchor.outline = ring_of(*outline);
  if (!anchor.id && !anchor.at) field.fail("at_m (a place in the room), id (its number) or both");
  return anchor;
}

std::string name_of(const JsonField& field) {
  std::string name = field.text();
  const bool is_printable =
      std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; });
  if (name.find_first_not_of(' ') == std::string::npos || !is_printable) {
    field.fail("one line of text that is not empty");
  }
  if (name.size() > kLongestRoomName) field.fail("at most 200 bytes of text");
  return name;
}

RoomKind kind_of(const JsonField& field) {
  for (const RoomKind kind : {RoomKind::room, RoomKind::corridor, RoomKind::hall}) {
    if (field.text() == to_string(kind)) return kind;
  }
  field.fail("\"room\", \"corridor\" or \"hall\"");
}

Pose2 pose_of(const Json& json, const JsonField& field) {
  if (!json.is_object()) field.fail("an object with x_m, y_m and theta_rad");
  require_known(json, field, {"x_m", "y_m", "theta_rad"});
  return {field.at("x_m").number(), field.at("y_m").number(),
          wrap_angle(field.at("theta_rad").number())};
}

void read_rooms(const Json& json, const JsonField& statement, Edit& edit) {
  if (json.contains("room")) {
    edit.rooms = {anchor_of(json["room"], statement.at("room"))};
    return;
  }
  const JsonField rooms = statement.at(edit.kind == EditKind::join_rooms ? "rooms" : "room");
  if (rooms.size() != 2) rooms.fail("two rooms");
  for (std::size_t i = 0; i < 2; ++i) {
    edit.rooms.push_back(anchor_of(json["rooms"][i], rooms.element(i)));
  }
}

void read_field(const std::string& name, const Json& json, const JsonField& statement, Edit& edit) {
  if (name == "room" || name == "rooms") {
    read_rooms(json, statement, edit);
  } else if (name == "name") {
    edit.name = name_of(statement.at(name));
  } else if (name == "kind") {
    edit.room_kind = kind_of(statement.at(name));
  } else if (name == edits_schema::line_field(edit.kind)) {
    edit.line = line_of(statement.at(name));
  } else if (name == "at_m") {
    edit.at = point_of(statement.at(name));
  } else if (name == "outline_m") {
    if (const auto outline = statement.find(name)) edit.outline = ring_of(*outline);
  } else if (name == "by_m") {
    edit.by_m = statement.at(name).number();
    if (edit.by_m == 0.0) statement.at(name).fail("metres to the left of wall_m, not 0");
  } else if (name == "thickness_m") {
    if (const auto thickness = statement.find(name)) {
      edit.thickness_m = thickness->number_not_negative();
      if (edit.thickness_m > kThickest_m) thickness->fail("metres, at most 2");
    }
  } else if (name == "from_time_s") {
    edit.from_time_s = statement.at(name).number();
  } else if (name == "to_time_s") {
    edit.to_time_s = statement.at(name).number();
  } else {
    edit.from_from_to =
        pose_of(statement.at(name).is_null() ? Json() : json[name], statement.at(name));
  }
}

Edit edit_of(const Json& json, const JsonField& statement) {
  const JsonField word = statement.at("edit");
  std::vector<std::string> words;
  for (const edits_schema::Statement& one : edits_schema::statements()) {
    words.emplace_back(to_string(one.kind));
    if (word.text() != words.back()) continue;
    std::vector<std::string> known = one.fields;
    known.insert(known.end(), {"edit", "note"});
    require_known(json, statement, known);
    Edit edit;
    edit.kind = one.kind;
    for (const std::string& field : one.fields) read_field(field, json, statement, edit);
    return edit;
  }
  word.fail("a kind of statement; the nearest is \"" + io::nearest_name(word.text(), words) + "\"");
}

}  // namespace

std::vector<Edit> edits_of(const std::string& text, const std::string& file) {
  const Json json = io::parse_json(text, file);
  const JsonField document(json, file, "");
  const JsonField format = document.at("format");
  if (format.text() != edits_schema::kFormat) format.fail("\"roomatlas-edits\"");
  const JsonField version = document.at("version");
  if (version.positive_integer() != edits_schema::kVersion) version.fail("version 1");
  require_known(json, document, {"format", "version", "frame", "edits"});
  if (const auto frame = document.find("frame"); frame && frame->text() != "building") {
    frame->fail("\"building\": metres in the frame of the plan");
  }
  const JsonField list = document.at("edits");
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < list.size(); ++i) {
    edits.push_back(edit_of(json["edits"][i], list.element(i)));
  }
  return edits;
}

std::vector<Edit> read_edits(const Path& file) {
  return edits_of(read_text_file(file), file.string());
}

}  // namespace roomatlas
