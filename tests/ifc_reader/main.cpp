// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an IFC file with IfcPlusPlus, a reader that knows nothing of us, and prints what it found:
// a line for each kind of entity and how many there are, a line for each solid product with its
// GlobalId, volume in m3 and highest point in m, once openings are cut out, and each complaint.
#include <ifcpp/IFC4/include/IfcBuildingStorey.h>
#include <ifcpp/IFC4/include/IfcGloballyUniqueId.h>
#include <ifcpp/IFC4/include/IfcProduct.h>
#include <ifcpp/geometry/Carve/GeometryConverter.h>
#include <ifcpp/model/BuildingModel.h>
#include <ifcpp/reader/ReaderSTEP.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>

namespace {

std::string narrow(const std::wstring& text) { return {text.begin(), text.end()}; }

void print_message(void*, shared_ptr<StatusCallback::Message> message) {
  if (message == nullptr ||
      message->m_message_type == StatusCallback::MESSAGE_TYPE_PROGRESS_VALUE ||
      message->m_message_type == StatusCallback::MESSAGE_TYPE_PROGRESS_TEXT ||
      message->m_message_type == StatusCallback::MESSAGE_TYPE_GENERAL_MESSAGE) {
    return;
  }
  std::cout << "complaint " << narrow(message->m_message_text) << '\n';
}

struct Solid {
  double volume_m3 = 0.0;
  double highest_m = -1e9;
};

/// By the divergence theorem, over triangles of each face.
void add(const carve::mesh::MeshSet<3>& mesh, Solid& solid) {
  for (auto face = mesh.faceBegin(); face != mesh.faceEnd(); ++face) {
    std::vector<carve::mesh::MeshSet<3>::vertex_t*> corners;
    (*face)->getVertices(corners);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const auto& a = corners[0]->v;
      const auto& b = corners[i]->v;
      const auto& c = corners[i + 1]->v;
      solid.volume_m3 += carve::geom::dotcross(a, b, c) / 6.0;
    }
    for (const auto* corner : corners) solid.highest_m = std::max(solid.highest_m, corner->v.z);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ifstream stream(arguments[1], std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  shared_ptr<BuildingModel> model(new BuildingModel());
  ReaderSTEP reader;
  reader.setMessageCallBack(nullptr, print_message);
  reader.loadModelFromString(content, model);
  std::map<std::string, int> kinds;
  for (const auto& [id, entity] : model->getMapIfcEntities()) {
    if (entity) ++kinds[entity->className()];
  }
  for (const auto& [kind, number] : kinds) std::cout << kind << ' ' << number << '\n';

  GeometryConverter converter(model);
  converter.setMessageCallBack(nullptr, print_message);
  converter.convertGeometry();
  for (const auto& [id, shape] : converter.getShapeInputData()) {
    const shared_ptr<IfcProduct> product =
        dynamic_pointer_cast<IfcProduct>(shape->m_ifc_object_definition.lock());
    if (!product) continue;
    Solid solid;
    shape->applyTransformToProduct(shape->getTransform());
    for (const auto& representation : shape->m_vec_representations) {
      for (const auto& item : representation->m_vec_item_data) {
        for (const auto& mesh : item->m_meshsets) add(*mesh, solid);
      }
    }
    if (solid.volume_m3 == 0.0) continue;
    std::cout << "solid " << product->className() << ' ' << narrow(product->m_GlobalId->m_value)
              << ' ' << solid.volume_m3 << ' ' << solid.highest_m << '\n';
  }
}
