// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace roomatlas::test::imdf {

/// What the specification's tables of properties say: which must be there, and may be null where
/// marked so.
enum class Kind {
  text,
  text_or_null,
  labels,
  labels_or_null,
  point,
  point_or_null,
  id,
  id_or_null,
  ids,
  ids_or_null,
  truth,
  whole,
  category,
  null_or_list,
  door_or_null,
  reference_or_null,
  references_or_null,
};
using Keys = std::map<std::string, Kind>;

struct Type {
  std::set<std::string> geometries;  ///< empty: null
  std::set<std::string> categories;
  Keys keys;
};

/// The types of features that we write, by name.
const std::map<std::string, Type>& types();

}  // namespace roomatlas::test::imdf
