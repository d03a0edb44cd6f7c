// SPDX-License-Identifier: GPL-3.0-or-later
// The plug-in roomatlas-gdal: vector files of any format that GDAL can create.
#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "ogr_geometry.hpp"
#include "ogr_memory.hpp"

namespace roomatlas::ogr {
namespace {

using namespace io;

struct Close {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

/// While it lives GDAL prints nothing: what goes wrong is answered.
struct Quiet {
  Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~Quiet() { CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
};

/// Null where this GDAL has none of that name that writes vectors.
GDALDriver* driver_of(const std::string& name) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name.c_str());
  const bool can_write = driver != nullptr &&
                         driver->GetMetadataItem(GDAL_DCAP_VECTOR) != nullptr &&
                         driver->GetMetadataItem(GDAL_DCAP_CREATE) != nullptr;
  return can_write ? driver : nullptr;
}

/// A folder for formats that hold one layer a file, else a file.
std::string dataset_name(GDALDriver& driver, const VectorFile& file) {
  if (file.name.find('.') != std::string::npos) return file.name;
  for (const char* of_folders : {"ESRI Shapefile", "FlatGeobuf", "CSV", "MapInfo File"}) {
    if (file.driver == of_folders) return file.name;
  }
  const char* extension = driver.GetMetadataItem(GDAL_DMD_EXTENSION);
  return file.name + (extension == nullptr ? "" : std::string(".") + extension);
}

/// GDAL's template of a DXF header says inches: ours are metres.
std::string header_in_metres() {
  const char* const file = CPLFindFile("gdal", "header.dxf");
  std::ifstream stream(file == nullptr ? "" : file, std::ios::binary);
  std::string header{std::istreambuf_iterator<char>(stream), {}};
  const auto set = [&](const std::string& variable, const std::string& value) {
    const std::size_t name = header.find(variable);
    const std::size_t code = name == std::string::npos ? name : header.find('\n', name);
    const std::size_t old = code == std::string::npos ? code : header.find('\n', code + 1);
    if (old == std::string::npos) {
      throw std::runtime_error("GDAL's header.dxf lacks " + variable);
    }
    header.replace(old + 1, header.find('\n', old + 1) - old - 1, value);
  };
  set("$INSUNITS", "6");
  set("$MEASUREMENT", "1");
  return header;
}

OGRwkbGeometryType type_of(LayerShape shape) {
  switch (shape) {
    case LayerShape::lines:
      return wkbLineString;
    case LayerShape::polygons:
      return wkbPolygon;
    case LayerShape::multi_polygons:
      return wkbMultiPolygon;
    case LayerShape::any:
      break;
  }
  return wkbUnknown;
}

OGRFieldType type_of(FieldType type) {
  if (type == FieldType::integer) return OFTInteger64;
  return type == FieldType::real ? OFTReal : OFTString;
}

/// The layer's fields as numbers of OGR's; those that are not there yet are made.
std::vector<int> columns_of(OGRLayer& made, const VectorLayer& layer) {
  std::vector<int> columns;
  for (const VectorField& field : layer.fields) {
    OGRFieldDefn definition(field.name.c_str(), type_of(field.type));
    OGRFeatureDefn& all = *made.GetLayerDefn();
    if (all.GetFieldIndex(field.name.c_str()) < 0 && made.CreateField(&definition) != OGRERR_NONE) {
      throw std::runtime_error(last_error());
    }
    columns.push_back(all.GetFieldIndex(field.name.c_str()));
  }
  return columns;
}

struct SetField {
  OGRFeature& feature;
  int column;
  void operator()(std::monostate) const {}
  void operator()(std::int64_t value) const {
    feature.SetField(column, static_cast<GIntBig>(value));
  }
  void operator()(double value) const { feature.SetField(column, value); }
  void operator()(const std::string& value) const { feature.SetField(column, value.c_str()); }
};

void add_layer(GDALDataset& dataset, const VectorLayer& layer) {
  OGRSpatialReference metres;
  metres.SetLocalCS("Building metres");
  metres.SetLinearUnits(SRS_UL_METER, 1.0);
  OGRLayer* const made = dataset.CreateLayer(layer.name.c_str(), &metres, type_of(layer.shape));
  if (made == nullptr) throw std::runtime_error("layer " + layer.name + ": " + last_error());
  const std::vector<int> columns = columns_of(*made, layer);
  for (const VectorFeature& from : layer.features) {
    OGRFeature feature(made->GetLayerDefn());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      std::visit(SetField{feature, columns[i]}, from.values.at(i));
    }
    if (!from.style.empty()) feature.SetStyleString(from.style.c_str());
    if (feature.SetGeometry(to_ogr(from.shape).get()) != OGRERR_NONE ||
        made->CreateFeature(&feature) != OGRERR_NONE) {
      throw std::runtime_error(last_error());
    }
  }
}

void encode(GDALDriver& driver, const VectorFile& file, VectorFileBytes& bytes) {
  const MemoryFolder results("files");
  const MemoryFolder templates("templates");
  CPLStringList options;
  if (file.driver == "DXF") {
    templates.put("header.dxf", header_in_metres());
    options.SetNameValue("HEADER", templates.path("header.dxf").c_str());
  }
  {
    const std::string name = results.path(dataset_name(driver, file));
    const Dataset dataset(driver.Create(name.c_str(), 0, 0, 0, GDT_Unknown, options.List()));
    if (dataset == nullptr) throw std::runtime_error(last_error());
    for (const VectorLayer& layer : file.layers) add_layer(*dataset, layer);
  }
  bytes.files = results.files();
}

}  // namespace
}  // namespace roomatlas::ogr

/// The one entry. No exception leaves it.
extern "C" void roomatlas_encode_vector_file_1(const roomatlas::io::VectorFile& file,
                                               roomatlas::io::VectorFileBytes& bytes) try {
  const roomatlas::ogr::Quiet quiet;
  GDALDriver* const driver = roomatlas::ogr::driver_of(file.driver);
  bytes.is_unknown_format = driver == nullptr;
  if (driver != nullptr) roomatlas::ogr::encode(*driver, file, bytes);
} catch (const std::exception& error) {
  bytes.error = error.what();
}
