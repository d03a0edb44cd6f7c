// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "json_fwd.hpp"

namespace roomatlas {

/// A value inside a JSON document that knows where it stands, so that whatever is wrong with it
/// is reported as `file: features[3].properties.width_m: expected ..., found ...`. Refers to the
/// document, which must outlive it. Every accessor throws InputError when the value is not what
/// it asks for.
class JsonField {
 public:
  JsonField(const Json& value, std::string file, std::string place)
      : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

  /// A member that must be there.
  [[nodiscard]] JsonField at(const std::string& key) const;
  /// A member that may be missing; null counts as missing.
  [[nodiscard]] std::optional<JsonField> find(const std::string& key) const;
  /// @param index less than `size()`
  [[nodiscard]] JsonField element(std::size_t index) const;
  [[nodiscard]] std::size_t size() const;  ///< of an array

  [[nodiscard]] bool is_null() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] double number_not_negative() const;
  [[nodiscard]] std::int64_t positive_integer() const;
  [[nodiscard]] std::string text() const;

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  const Json* value_;
  std::string file_;
  std::string place_;
};

}  // namespace roomatlas
