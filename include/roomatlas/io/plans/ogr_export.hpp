// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomatlas/plan/floor_plan.hpp"

namespace roomatlas {

/// Whether the plug-in roomatlas-gdal can be loaded, and with it the formats below are there.
[[nodiscard]] bool has_ogr();

/// The plan as DXF in metres, model space, with the layer names of the U.S. National CAD Standard
/// (AIA): A-WALL, A-WALL-MEAS, A-WALL-INFR and A-WALL-UNEX (edges of rooms by evidence), A-DOOR,
/// A-DOOR-IDEN (widths), A-GLAZ, A-GLAZ-IDEN (windows), A-AREA (outlines of rooms), A-AREA-IDEN
/// (names and areas), A-FURN (at walls), A-FURN-FREE, A-ANNO-DIMS (chains of dimensions as lines
/// and texts). Outlines are closed polylines. Throws InputError when it cannot be written,
/// UsageError without the plug-in.
void write_dxf(const std::filesystem::path& file, const FloorPlan& plan);

/// The plan in a vector format of OGR, in building metres: layers rooms, doors, walls and, where
/// there are any, furniture, edges and leaves, with the columns of the store. Throws UsageError
/// without the plug-in and for a format that its GDAL cannot write, InputError when writing fails.
/// @param driver as `ogrinfo --formats` names it, such as "GML" or "ESRI Shapefile"
/// @param out folder; files there are called `plan_DRIVER...`
/// @returns the files' names
std::vector<std::string> write_ogr(const std::filesystem::path& out, const std::string& driver,
                                   const FloorPlan& plan);

}  // namespace roomatlas
