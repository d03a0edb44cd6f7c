// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace roomatlas {

/// A universally unique identifier (RFC 4122).
struct Uuid {
  std::array<std::uint8_t, 16> bytes{};

  /// "11111111-2222-4333-8444-555555555555".
  [[nodiscard]] std::string text() const;
  /// The 22 characters of an IFC GlobalId: the same 128 bits, base 64 by buildingSMART's alphabet.
  [[nodiscard]] std::string ifc() const;
};

/// The identifiers of a building's things. They hang on the building and on what a thing is called
/// by those who do not rename it ("room/7"), and on nothing else, so that the same room has the
/// same one in every export. The bits are those of a SHA-256, marked as version 4, the only one
/// that IMDF accepts (OGC 20-094, "Type Designators").
class FeatureIds {
 public:
  /// @param building what tells the building from others, such as the SHA-256 of its first mission
  explicit FeatureIds(std::string building) : building_(std::move(building)) {}

  [[nodiscard]] Uuid of(const std::string& thing) const;

 private:
  std::string building_;
};

}  // namespace roomatlas
