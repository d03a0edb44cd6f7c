// SPDX-License-Identifier: GPL-3.0-or-later
#include "roomatlas/io/plans/edits_file.hpp"

#include <gmock/gmock.h>

#include "roomatlas/core/issue.hpp"

namespace roomatlas {
namespace {

using ::testing::HasSubstr;

constexpr const char* kAllKinds = R"({
 "format": "roomatlas-edits",
 "version": 1,
 "frame": "building",
 "edits": [
  {"edit":"name_room","room":{"id":3,"at_m":[1.5,2.0],"outline_m":[[0.0,0.0],[3.0,0.0],[3.0,4.0]]},"name":"Kitchen"},
  {"edit":"set_room_kind","room":{"at_m":[1.0,2.0]},"kind":"corridor"},
  {"edit":"join_rooms","rooms":[{"id":1},{"id":2}]},
  {"edit":"split_room","room":{"at_m":[1.0,2.0]},"line_m":[[1.0,0.0],[1.0,4.0]],"thickness_m":0.1},
  {"edit":"shut_door","at_m":[1.0,2.0]},
  {"edit":"open_door","at_m":[1.0,2.0]},
  {"edit":"add_door","jambs_m":[[1.0,0.0],[1.0,0.9]]},
  {"edit":"move_wall","wall_m":[[1.0,0.0],[1.0,4.0]],"by_m":-0.2},
  {"edit":"furniture_to_wall","at_m":[1.0,2.0]},
  {"edit":"wall_to_furniture","at_m":[1.0,2.0],"outline_m":[[0.0,0.0],[3.0,0.0],[3.0,4.0]]},
  {"edit":"reject_closure","from_time_s":12.5,"to_time_s":80.0},
  {"edit":"pin_visits","from_time_s":12.5,"to_time_s":80.0,"from_from_to":{"x_m":1.0,"y_m":0.5,"theta_rad":0.1}}
 ]
}
)";

/// A file with one statement.
std::string with(const std::string& statement) {
  return R"({"format":"roomatlas-edits","version":1,"edits":[)" + statement + "]}";
}

std::string error_of(const std::string& text) {
  try {
    (void)edits_of(text, "e.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(EditsFile, EveryKindIsReadAndWrittenToTheSameBytes) {
  const std::vector<Edit> edits = edits_of(kAllKinds, "e.json");
  ASSERT_EQ(edits.size(), 12U);
  EXPECT_EQ(edits[0].rooms.at(0).id, 3);
  EXPECT_EQ(edits[7].by_m, -0.2);
  EXPECT_EQ(edits[11].from_from_to.y_m, 0.5);
  EXPECT_EQ(edits_json(edits), kAllKinds);
  EXPECT_TRUE(edits_of(edits_json({}), "e.json").empty());
}

TEST(EditsFile, ErrorsNameFileStatementFieldAndWhatIsExpected) {
  EXPECT_EQ(error_of(with(R"({"edit":"shut_door","at_m":[1,"x"]})")),
            "e.json: edits[0].at_m[1]: expected a finite number, found \"x\"");
  EXPECT_THAT(error_of(with(R"({"edit":"shut_dor","at_m":[1,2]})")),
              HasSubstr("e.json: edits[0].edit: expected a kind of statement; the nearest is "
                        "\"shut_door\", found \"shut_dor\""));
  EXPECT_THAT(error_of(with(R"({"edit":"shut_door","at_m":[1,2],"by":3})")),
              HasSubstr("edits[0].by: expected no such field"));
  EXPECT_THAT(error_of(with(R"({"edit":"name_room","room":{},"name":"A"})")),
              HasSubstr("edits[0].room: expected at_m"));
  EXPECT_THAT(error_of(with(R"({"edit":"name_room","room":{"id":1},"name":" "})")),
              HasSubstr("edits[0].name: expected one line of text"));
  EXPECT_THAT(error_of(with(R"({"edit":"set_room_kind","room":{"id":1},"kind":"den"})")),
              HasSubstr("expected \"room\", \"corridor\" or \"hall\", found \"den\""));
  EXPECT_THAT(error_of(with(R"({"edit":"join_rooms","rooms":[{"id":1}]})")),
              HasSubstr("edits[0].rooms: expected two rooms"));
  EXPECT_THAT(error_of(with(R"({"edit":"add_door","jambs_m":[[1,2],[1,2]]})")),
              HasSubstr("two points that are 0.05 m apart"));
  EXPECT_THAT(error_of(with(R"({"edit":"move_wall","wall_m":[[1,2],[1,4]]})")),
              HasSubstr("edits[0].by_m: missing"));
  EXPECT_THAT(error_of(with(R"({"edit":"pin_visits","from_time_s":1,"to_time_s":2,)"
                            R"("from_from_to":3})")),
              HasSubstr("edits[0].from_from_to: expected an object"));
  EXPECT_THAT(error_of(R"({"format":"roomatlas-edits","version":2,"edits":[]})"),
              HasSubstr("version: expected version 1, found 2"));
  EXPECT_THAT(error_of(R"({"format":"roomatlas-edits","version":1,"edits":[],"edits":[{}]})"),
              HasSubstr("e.json: field \"edits\" stands twice in one object"));
  EXPECT_THAT(error_of(with(R"({"edit":"name_room","room":{"id":1},"name":")" +
                            std::string(1000000, 'a') + R"("})")),
              HasSubstr("edits[0].name: expected at most 200 bytes"));
  EXPECT_THAT(error_of("{"), HasSubstr("e.json: not valid JSON"));
  EXPECT_THAT(error_of("[]"), HasSubstr("expected an object"));
}

}  // namespace
}  // namespace roomatlas
