// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

/// Colours and line widths. The tints differ in lightness as well as in hue, and use the axis
/// blue to yellow, so that they stay apart for readers who are red-green blind and on grey prints.
namespace roomatlas::drawing {

constexpr const char* kInk = "#1f2933";       // text
constexpr const char* kFaintInk = "#5f6b7a";  // captions, dimensions
constexpr const char* kWallFill = "#39424e";
constexpr const char* kDoorFill = "#ffffff";
constexpr const char* kFurnitureFill = "#c9ced6";
constexpr const char* kPathStroke = "#d55e00";
constexpr const char* kGraphStroke = "#0072b2";
constexpr const char* kCorrectionStroke = "#a2337c";
constexpr const char* kUncertaintyStroke = "#00795c";
constexpr const char* kUnexploredStroke = "#5f6b7a";

constexpr const char* kUnexploredDash = "1.6 1";

constexpr const char* kHairline_mm = "0.13";
constexpr const char* kThin_mm = "0.2";
constexpr const char* kFrame_mm = "0.35";

[[nodiscard]] constexpr const char* tint(RoomKind kind) {
  switch (kind) {
    case RoomKind::corridor:
      return "#fff3cd";
    case RoomKind::hall:
      return "#c3d3ea";
    case RoomKind::room:
      break;
  }
  return "#e4eff8";
}

}  // namespace roomatlas::drawing
