// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

/// Clear text files of ISO 10303-21 ("STEP"). Private.
namespace roomatlas::io::step {

/// An argument of an instance, already in the file's notation.
using Value = std::string;

[[nodiscard]] Value text(const std::string& utf8);  ///< 'it''s', "ä" as \X2\00E4\X0\.
[[nodiscard]] Value real(double value);             ///< "2.5", "-1.", rounded to 1e-9
[[nodiscard]] Value list(const std::vector<Value>& values);
[[nodiscard]] Value word(const std::string& name);  ///< of an enumeration: ".TRUE."

constexpr const char* kNone = "$";
constexpr const char* kDerived = "*";

/// The instances of a file, numbered from 1 in the order in which they were added.
class File {
 public:
  /// @returns the reference to it, such as "#7"
  Value add(const std::string& type, const std::vector<Value>& arguments);
  /// The same instance for the same arguments.
  Value shared(const std::string& type, const std::vector<Value>& arguments);
  /// The whole file. @param schema such as "IFC4" @param time ISO 8601
  [[nodiscard]] std::string finish(const std::string& schema, const std::string& description,
                                   const std::string& name, const std::string& time) const;

 private:
  std::string data_;
  std::size_t count_ = 0;
  std::map<std::string, Value> shared_;
};

}  // namespace roomatlas::io::step
