// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_styles.hpp"

#include "geopackage_schema.hpp"

#include <optional>
#include <string>

namespace roomatlas {
namespace {

// The columns that QGIS looks for, without the default that would read the clock.
constexpr const char* kSql = R"sql(
CREATE TABLE layer_styles (
  id INTEGER PRIMARY KEY,
  f_table_catalog TEXT(256),
  f_table_schema TEXT(256),
  f_table_name TEXT(256),
  f_geometry_column TEXT(256),
  styleName TEXT(30),
  styleQML TEXT,
  styleSLD TEXT,
  useAsDefault BOOLEAN,
  description TEXT,
  owner TEXT(30),
  ui TEXT(30),
  update_time DATETIME);
)sql";

std::string property(const char* key, const std::string& value) {
  return std::string("<prop k=\"") + key + "\" v=\"" + value + "\"/>";
}

/// @param colour red, green, blue, opacity, each up to 255
std::string fill_symbol(const std::string& name, const std::string& colour,
                        const std::string& outline) {
  return "<symbol type=\"fill\" name=\"" + name + "\" alpha=\"1\"><layer class=\"SimpleFill\">" +
         property("color", colour) + property("style", "solid") +
         property("outline_color", outline) + property("outline_style", "solid") +
         property("outline_width", "0.2") + property("outline_width_unit", "MM") +
         "</layer></symbol>";
}

std::string outline_symbol(const std::string& colour) {
  return "<symbol type=\"fill\" name=\"0\" alpha=\"1\"><layer class=\"SimpleFill\">" +
         property("style", "no") + property("outline_color", colour) +
         property("outline_style", "dash") + property("outline_width", "0.2") +
         property("outline_width_unit", "MM") + "</layer></symbol>";
}

std::string line_symbol(const std::string& colour) {
  return "<symbol type=\"line\" name=\"0\" alpha=\"1\"><layer class=\"SimpleLine\">" +
         property("line_color", colour) + property("line_style", "solid") +
         property("line_width", "0.2") + property("line_width_unit", "MM") + "</layer></symbol>";
}

std::string document(const std::string& body) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
         "<qgis version=\"3.22.0\" styleCategories=\"Symbology|Labeling\" labelsEnabled=\"1\">" +
         body + "</qgis>\n";
}

std::string single(const std::string& symbol) {
  return document("<renderer-v2 type=\"singleSymbol\" symbollevels=\"0\"><symbols>" + symbol +
                  "</symbols></renderer-v2>");
}

std::string rooms_style() {
  const std::string edge = "57,66,78,255";
  const auto category = [](const char* symbol, const char* kind) {
    return std::string("<category symbol=\"") + symbol + "\" value=\"" + kind + "\" label=\"" +
           kind + "\" render=\"true\"/>";
  };
  return document(
      "<renderer-v2 type=\"categorizedSymbol\" attr=\"kind\" symbollevels=\"0\"><categories>" +
      category("0", "room") + category("1", "corridor") + category("2", "hall") +
      "</categories><symbols>" + fill_symbol("0", "228,239,248,255", edge) +
      fill_symbol("1", "255,243,205,255", edge) + fill_symbol("2", "195,211,234,255", edge) +
      "</symbols></renderer-v2>"
      "<labeling type=\"simple\"><settings><text-style isExpression=\"1\" fontSize=\"8\" "
      "fontFamily=\"DejaVu Sans\" textColor=\"31,41,51,255\" fieldName=\"name || '\\n' || "
      "round(area_m2, 1) || ' m²'\"/><placement placement=\"1\"/></settings></labeling>");
}

std::string dashed_line(const std::string& name, const std::string& colour, const char* style) {
  return "<symbol type=\"line\" name=\"" + name + "\" alpha=\"1\"><layer class=\"SimpleLine\">" +
         property("line_color", colour) + property("line_style", style) +
         property("line_width", "0.35") + property("line_width_unit", "MM") + "</layer></symbol>";
}

std::string edges_style() {
  const auto category = [](const char* symbol, const char* evidence) {
    return std::string("<category symbol=\"") + symbol + "\" value=\"" + evidence + "\" label=\"" +
           evidence + "\" render=\"true\"/>";
  };
  return document(
      "<renderer-v2 type=\"categorizedSymbol\" attr=\"evidence\" symbollevels=\"0\"><categories>" +
      category("0", "measured") + category("1", "inferred") + category("2", "unexplored") +
      "</categories><symbols>" + dashed_line("0", "57,66,78,255", "solid") +
      dashed_line("1", "255,255,255,255", "dash") + dashed_line("2", "213,94,0,255", "dot") +
      "</symbols></renderer-v2>");
}

void add_style(Database& database, const char* layer, const std::string& qml) {
  database.run(
      "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, "
      "f_geometry_column, styleName, styleQML, styleSLD, useAsDefault, description, owner, "
      "update_time) VALUES ('', '', ?, 'geom', ?, ?, '', 1, 'As on the drawing', '', ?)",
      layer, layer, qml, last_change_of(std::nullopt));
}

}  // namespace

void create_layer_styles(Database& database) {
  database.execute(kSql);
  database.run(
      "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, last_change) "
      "VALUES ('layer_styles', 'attributes', 'layer_styles', 'How QGIS draws the layers', ?)",
      last_change_of(std::nullopt));
  add_style(database, "rooms", rooms_style());
  add_style(database, "walls", single(fill_symbol("0", "57,66,78,255", "57,66,78,255")));
  add_style(database, "doors", single(fill_symbol("0", "255,255,255,255", "95,107,122,255")));
  add_style(database, "free_space", single(outline_symbol("95,107,122,255")));
  add_style(database, "furniture", single(fill_symbol("0", "201,206,214,255", "95,107,122,255")));
  add_style(database, "edges", edges_style());
  add_style(database, "path", single(line_symbol("213,94,0,255")));
}

}  // namespace roomatlas
