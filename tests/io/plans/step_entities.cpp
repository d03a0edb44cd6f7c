// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_entities.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace roomatlas::test {
namespace {

/// What an attribute may be; a letter each:
///   g GlobalId        s text         r number          i whole number     e enumeration
///   # reference       S list of references              R list of numbers   I list of whole
///   numbers
/// A question mark behind it allows $; * stands for a derived one. A reference is followed by the
/// types that it may lead to.
struct Attribute {
  char kind = 's';
  bool is_optional = false;
  std::set<std::string> types;
};

Attribute attribute_of(const std::string& written) {
  Attribute attribute{written[0], false, {}};
  std::string rest = written.substr(1);
  if (!rest.empty() && rest[0] == '?') {
    attribute.is_optional = true;
    rest.erase(0, 1);
  }
  std::istringstream stream(rest);
  for (std::string type; std::getline(stream, type, '|');) attribute.types.insert(type);
  return attribute;
}

/// The attributes of ISO 16739 (IFC4 ADD2 TC1) of the entities that we write.
const std::map<std::string, std::string>& schema() {
  const std::string root = "g #? s? s? ";
  const std::string product = root + "s? #?IFCLOCALPLACEMENT #?IFCPRODUCTDEFINITIONSHAPE ";
  const std::string spatial = product + "s? e? ";
  static const std::map<std::string, std::string> table = {
      {"IFCSIUNIT", "* e e? e"},
      {"IFCUNITASSIGNMENT", "SIFCSIUNIT"},
      {"IFCCARTESIANPOINT", "R"},
      {"IFCDIRECTION", "R"},
      {"IFCAXIS2PLACEMENT2D", "#IFCCARTESIANPOINT #?IFCDIRECTION"},
      {"IFCAXIS2PLACEMENT3D", "#IFCCARTESIANPOINT #?IFCDIRECTION #?IFCDIRECTION"},
      {"IFCLOCALPLACEMENT", "#?IFCLOCALPLACEMENT #IFCAXIS2PLACEMENT3D"},
      {"IFCGEOMETRICREPRESENTATIONCONTEXT", "s? s? i r? #IFCAXIS2PLACEMENT3D #?IFCDIRECTION"},
      {"IFCGEOMETRICREPRESENTATIONSUBCONTEXT",
       "s? s? * * * * #IFCGEOMETRICREPRESENTATIONCONTEXT r? e s?"},
      {"IFCPOLYLINE", "SIFCCARTESIANPOINT"},
      {"IFCARBITRARYCLOSEDPROFILEDEF", "e s? #IFCPOLYLINE"},
      {"IFCARBITRARYPROFILEDEFWITHVOIDS", "e s? #IFCPOLYLINE SIFCPOLYLINE"},
      {"IFCRECTANGLEPROFILEDEF", "e s? #?IFCAXIS2PLACEMENT2D r r"},
      {"IFCEXTRUDEDAREASOLID",
       "#IFCARBITRARYCLOSEDPROFILEDEF|IFCARBITRARYPROFILEDEFWITHVOIDS|IFCRECTANGLEPROFILEDEF "
       "#?IFCAXIS2PLACEMENT3D #IFCDIRECTION r"},
      {"IFCSHAPEREPRESENTATION",
       "#IFCGEOMETRICREPRESENTATIONSUBCONTEXT s? s? SIFCEXTRUDEDAREASOLID|IFCPOLYLINE"},
      {"IFCPRODUCTDEFINITIONSHAPE", "s? s? SIFCSHAPEREPRESENTATION"},
      {"IFCPROJECT", root + "s? s? s? SIFCGEOMETRICREPRESENTATIONCONTEXT #IFCUNITASSIGNMENT"},
      {"IFCSITE", spatial + "I? I? r? s? #?"},
      {"IFCBUILDING", spatial + "r? r? #?"},
      {"IFCBUILDINGSTOREY", spatial + "r?"},
      {"IFCSPACE", spatial + "e? r?"},
      {"IFCWALL", product + "s? e?"},
      {"IFCOPENINGELEMENT", product + "s? e?"},
      {"IFCFURNITURE", product + "s? e?"},
      {"IFCDOOR", product + "s? r? r? e? e? s?"},
      {"IFCWINDOW", product + "s? r? r? e? e? s?"},
      {"IFCRELAGGREGATES", root + "#IFCPROJECT|IFCSITE|IFCBUILDING|IFCBUILDINGSTOREY "
                                  "SIFCSITE|IFCBUILDING|IFCBUILDINGSTOREY|IFCSPACE"},
      {"IFCRELCONTAINEDINSPATIALSTRUCTURE",
       root + "SIFCWALL|IFCDOOR|IFCWINDOW|IFCFURNITURE #IFCBUILDINGSTOREY"},
      {"IFCRELVOIDSELEMENT", root + "#IFCWALL #IFCOPENINGELEMENT"},
      {"IFCRELFILLSELEMENT", root + "#IFCOPENINGELEMENT #IFCDOOR|IFCWINDOW"},
      {"IFCRELDEFINESBYPROPERTIES", root + "SIFCSPACE #IFCELEMENTQUANTITY"},
      {"IFCRELASSOCIATESMATERIAL", root + "SIFCWALL #IFCMATERIALLAYERSETUSAGE"},
      {"IFCELEMENTQUANTITY", root + "s? SIFCQUANTITYAREA|IFCQUANTITYLENGTH|IFCQUANTITYVOLUME"},
      {"IFCQUANTITYLENGTH", "s s? #? r s?"},
      {"IFCQUANTITYAREA", "s s? #? r s?"},
      {"IFCQUANTITYVOLUME", "s s? #? r s?"},
      {"IFCMATERIAL", "s s? s?"},
      {"IFCMATERIALLAYER", "#?IFCMATERIAL r e? s? s? s? i?"},
      {"IFCMATERIALLAYERSET", "SIFCMATERIALLAYER s? s?"},
      {"IFCMATERIALLAYERSETUSAGE", "#IFCMATERIALLAYERSET e e r r?"}};
  return table;
}

const std::set<std::string>& enumerators() {
  static const std::set<std::string> words = {
      "LENGTHUNIT",   "AREAUNIT",    "VOLUMEUNIT", "PLANEANGLEUNIT",    "METRE",
      "SQUARE_METRE", "CUBIC_METRE", "RADIAN",     "MODEL_VIEW",        "GRAPH_VIEW",
      "AREA",         "ELEMENT",     "INTERNAL",   "SOLIDWALL",         "NOTDEFINED",
      "OPENING",      "DOOR",        "WINDOW",     "SINGLE_SWING_LEFT", "SINGLE_SWING_RIGHT",
      "AXIS2",        "POSITIVE"};
  return words;
}

/// The parts of a list or of arguments, at the outermost level.
std::vector<std::string> parts_of(const std::string& written) {
  std::vector<std::string> parts;
  std::string part;
  int depth = 0;
  bool is_text = false;
  for (const char c : written) {
    if (c == '\'') is_text = !is_text;
    if (!is_text && c == '(') ++depth;
    if (!is_text && c == ')') --depth;
    if (!is_text && depth == 0 && c == ',') {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

bool is_list(const std::string& written) {
  return written.size() > 2 && written.front() == '(' && written.back() == ')';
}

std::vector<std::string> items_of(const std::string& list) {
  return is_list(list) ? parts_of(list.substr(1, list.size() - 2)) : std::vector<std::string>{};
}

class Rules {
 public:
  explicit Rules(const std::string& file) : entities_(step_entities(file)) {
    static const std::regex header(
        R"(ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION\(.*\);\nFILE_NAME\(.*\);\nFILE_SCHEMA\(\('IFC4'\)\);\nENDSEC;\nDATA;\n)");
    require(std::regex_search(file.substr(0, 1000), header), "the header is another");
    require(file.ends_with("ENDSEC;\nEND-ISO-10303-21;\n"), "the end is another");
  }

  std::vector<std::string> broken() {
    for (const auto& [reference, entity] : entities_) check(reference, entity);
    check_relations();
    return broken_;
  }

 private:
  void require(bool holds, const std::string& sentence) {
    if (!holds) broken_.push_back(sentence);
  }

  void check(const std::string& reference, const StepEntity& entity) {
    const std::string name = reference + " " + entity.type;
    const auto found = schema().find(entity.type);
    if (found == schema().end()) return require(false, name + " is no entity that we write");
    std::istringstream stream(found->second);
    std::vector<std::string> attributes{std::istream_iterator<std::string>(stream), {}};
    if (attributes.size() != entity.arguments.size()) {
      return require(false, name + " has " + std::to_string(entity.arguments.size()) +
                                " attributes of " + std::to_string(attributes.size()));
    }
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      require(fits(attribute_of(attributes[i]), entity.arguments[i]),
              name + ": attribute " + std::to_string(i + 1) + " is " + entity.arguments[i]);
    }
    if (attributes.front() == "g") {
      require(ids_.insert(entity.arguments.front()).second, name + " has an id of another");
    }
  }

  bool leads(const Attribute& attribute, const std::string& reference) const {
    const auto found = entities_.find(reference);
    return found != entities_.end() && attribute.types.contains(found->second.type);
  }

  bool fits(const Attribute& attribute, const std::string& value) const {
    static const std::regex id("'[0-3][0-9A-Za-z_$]{21}'");
    static const std::regex text(R"re('([ -&(-\[\]-~]|''|\\\\|\\X[24]\\[0-9A-F]+\\X0\\)*')re");
    static const std::regex real(R"(-?\d+\.\d*(E-?\d+)?)");
    static const std::regex whole(R"(-?\d+)");
    static const std::regex enumeration(R"(\.([A-Z_0-9]+)\.)");
    if (attribute.kind == '*') return value == "*";
    if (value == "$") return attribute.is_optional;
    const auto all = [&](const auto& holds) {
      const std::vector<std::string> items = items_of(value);
      return !items.empty() && std::all_of(items.begin(), items.end(), holds);
    };
    std::smatch match;
    switch (attribute.kind) {
      case 'g':
        return std::regex_match(value, id);
      case 's':
        return std::regex_match(value, text);
      case 'r':
        return std::regex_match(value, real);
      case 'i':
        return std::regex_match(value, whole);
      case 'e':
        return std::regex_match(value, match, enumeration) && enumerators().contains(match[1]);
      case '#':
        return leads(attribute, value);
      case 'S':
        return all([&](const std::string& item) { return leads(attribute, item); });
      case 'R':
        return all([&](const std::string& item) { return std::regex_match(item, real); });
      case 'I':
        return all([&](const std::string& item) { return std::regex_match(item, whole); });
      default:
        return false;
    }
  }

  /// Of a relation, how often each thing stands on its side. @param at the attribute's index
  std::map<std::string, int> counted(const std::string& relation, std::size_t at) const {
    std::map<std::string, int> counts;
    for (const auto& [reference, entity] : entities_) {
      if (entity.type != relation) continue;
      const std::string& side = entity.arguments.at(at);
      if (!is_list(side)) ++counts[side];
      for (const std::string& item : items_of(side)) ++counts[item];
    }
    return counts;
  }

  /// Each thing of these types stands `least` to `most` times on that side.
  void require_count(const std::set<std::string>& types, const std::string& relation,
                     std::size_t at, int least, int most) {
    const std::map<std::string, int> counts = counted(relation, at);
    for (const auto& [reference, entity] : entities_) {
      if (!types.contains(entity.type)) continue;
      const auto found = counts.find(reference);
      const int count = found == counts.end() ? 0 : found->second;
      require(count >= least && count <= most, reference + " " + entity.type + " stands " +
                                                   std::to_string(count) + " times in " + relation);
    }
  }

  void check_relations() {
    std::map<std::string, int> kinds;
    for (const auto& [reference, entity] : entities_) ++kinds[entity.type];
    for (const char* one : {"IFCPROJECT", "IFCSITE", "IFCBUILDING", "IFCBUILDINGSTOREY"}) {
      require(kinds[one] == 1, std::string("there is not one ") + one);
    }
    require_count({"IFCSITE", "IFCBUILDING", "IFCBUILDINGSTOREY", "IFCSPACE"}, "IFCRELAGGREGATES",
                  5, 1, 1);
    require_count({"IFCWALL", "IFCDOOR", "IFCWINDOW", "IFCFURNITURE"},
                  "IFCRELCONTAINEDINSPATIALSTRUCTURE", 4, 1, 1);
    require_count({"IFCOPENINGELEMENT"}, "IFCRELVOIDSELEMENT", 5, 1, 1);
    require_count({"IFCOPENINGELEMENT"}, "IFCRELFILLSELEMENT", 4, 0, 1);
    require_count({"IFCDOOR", "IFCWINDOW"}, "IFCRELFILLSELEMENT", 5, 0, 1);
    require_count({"IFCSPACE"}, "IFCRELDEFINESBYPROPERTIES", 4, 1, 1);
    require_count({"IFCWALL"}, "IFCRELASSOCIATESMATERIAL", 4, 0, 1);
  }

  std::map<std::string, StepEntity> entities_;
  std::set<std::string> ids_;
  std::vector<std::string> broken_;
};

}  // namespace

std::map<std::string, StepEntity> step_entities(const std::string& file) {
  std::map<std::string, StepEntity> entities;
  std::istringstream lines(file.substr(file.find("DATA;\n") + 6));
  static const std::regex instance(R"((#\d+)=([A-Z0-9]+)\((.*)\);)");
  for (std::string line; std::getline(lines, line) && line != "ENDSEC;";) {
    std::smatch match;
    if (!std::regex_match(line, match, instance)) {
      entities[line] = {"?", {}};
      continue;
    }
    entities[match[1]] = {match[2], parts_of(match[3])};
  }
  return entities;
}

std::vector<std::string> broken_ifc_rules(const std::string& file) { return Rules(file).broken(); }

}  // namespace roomatlas::test
