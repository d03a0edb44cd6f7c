// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "roomatlas/core/geometry.hpp"

/// What the library tells the plug-in roomatlas-gdal: layers of shapes with their fields, and back
/// the files that hold them. Both are built of the same sources; the plug-in is linked with nothing
/// of the library.
namespace roomatlas::io {

enum class FieldType { integer, real, text };

struct VectorField {
  std::string name;
  FieldType type = FieldType::text;
};

/// Nothing: the field is left empty.
using FieldValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using VectorShape = std::variant<Point2, Polyline, Polygon, std::vector<Polygon>>;

struct VectorFeature {
  VectorShape shape;
  std::vector<FieldValue> values;  ///< one for each field of the layer
  std::string style;               ///< in OGR's language of feature styles; mostly empty
};

enum class LayerShape { any, lines, polygons, multi_polygons };

struct VectorLayer {
  std::string name;
  LayerShape shape = LayerShape::any;
  std::vector<VectorField> fields;  ///< made, but for those that the format itself has
  std::vector<VectorFeature> features;
};

/// A file in building metres.
struct VectorFile {
  std::string driver;  ///< as `ogrinfo --formats` names it
  std::string name;    ///< of the file; without a dot the plug-in adds the format's own ending
  std::vector<VectorLayer> layers;
};

/// The answer: the files, or what went wrong.
struct VectorFileBytes {
  std::vector<std::pair<std::string, std::string>> files;  ///< name below the folder, content
  std::string error;                                       ///< empty when all went well
  bool is_unknown_format = false;                          ///< this GDAL does not write the format
};

constexpr const char* kEncodeVectorFile = "roomatlas_encode_vector_file_1";
using EncodeVectorFile = void(const VectorFile& file, VectorFileBytes& bytes);

}  // namespace roomatlas::io
