// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "roomatlas/plan/floor_plan.hpp"

#include <array>

/// Colours and line widths. The tints differ in lightness as well as in hue, and use the axis
/// blue to yellow, so that they stay apart for readers who are red-green blind and on grey prints.
namespace roomatlas::drawing {

constexpr const char* kInk = "#1f2933";       // text
constexpr const char* kFaintInk = "#5f6b7a";  // captions, dimensions
constexpr const char* kWallFill = "#39424e";
constexpr const char* kPartitionFill = "#a9b1bb";  // of thin walls
constexpr const char* kInferredStroke = "#7b8794";
constexpr const char* kPaper = "#ffffff";
constexpr const char* kDoorFill = "#ffffff";
constexpr const char* kFurnitureFill = "#f4f5f7";
constexpr const char* kFurnitureStroke = "#8a94a1";
constexpr const char* kHatchStroke = "#b9c0c9";
constexpr const char* kPathStroke = "#d55e00";
constexpr const char* kGraphStroke = "#0072b2";
constexpr const char* kCorrectionStroke = "#a2337c";
constexpr const char* kUncertaintyStroke = "#00795c";
constexpr const char* kUnexploredStroke = "#5f6b7a";

/// Of the paths of several missions, after Okabe and Ito: they stay apart for colour-blind readers.
constexpr std::array<const char*, 8> kMissionStrokes = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                                        "#b8860b", "#56b4e9", "#5b2a86", "#1f2933"};

constexpr const char* kUnexploredDash = "1.6 1";
constexpr const char* kInferredDash = "0.9 0.6";
constexpr const char* kLintelDash = "1.2 0.7";

constexpr double kPartition_m = 0.14;   // walls up to here are drawn as partitions: a half-brick
                                        // wall with plaster; bearing walls are thicker
constexpr double kHatchPitch_mm = 1.3;  // between the lines of a hatch
constexpr double kAgainstWall_rad = 0.785398163397448;  // direction of a hatch: up to the right ...
constexpr double kFreeStanding_rad = -0.785398163397448;  // ... and down to the right

constexpr const char* kHairline_mm = "0.13";
constexpr const char* kThin_mm = "0.2";
constexpr const char* kFrame_mm = "0.35";

// Of notes: their letters, and from line to line.
constexpr double kNoteSize_mm = 2.2;
constexpr double kNoteLine_mm = 3.4;

/// Widths of lines in millimetres: a group of ISO 128, each next one thinner by the root of two.
struct LineWeights {
  double cut = 0.35;      ///< the outline of what a plan cuts through: walls
  double visible = 0.25;  ///< edges that are seen: leaves of doors, glass
  double fine = 0.18;     ///< dimensions, arcs, thresholds
  double hatch = 0.13;    ///< and furniture
};

/// Thinner at smaller scales, as on building drawings after DIN 1356: 0.5 mm for what is cut up to
/// 1:50, 0.35 mm up to 1:100, 0.25 mm beyond.
[[nodiscard]] constexpr LineWeights line_weights(int scale) {
  if (scale <= 50) return {0.5, 0.35, 0.25, 0.18};
  if (scale <= 125) return {0.35, 0.25, 0.18, 0.13};
  return {0.25, 0.18, 0.13, 0.13};
}

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
