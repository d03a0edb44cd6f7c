// SPDX-License-Identifier: GPL-3.0-or-later
#include "geopackage_tables.hpp"

namespace roomatlas {

// OGC 12-128r17, annex C, without the defaults that would read the clock.
const char* const kGeoPackageSql = R"sql(
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL PRIMARY KEY,
  organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL,
  definition TEXT NOT NULL,
  description TEXT);

INSERT INTO gpkg_spatial_ref_sys VALUES
 ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined',
  'undefined Cartesian coordinate reference system'),
 ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined',
  'undefined geographic coordinate reference system'),
 ('WGS 84 geodetic', 4326, 'EPSG', 4326,
  'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]',
  'longitude/latitude coordinates in decimal degrees on the WGS 84 spheroid'),
 ('Building metres', 100001, 'ROOMATLAS', 1,
  'LOCAL_CS["Building metres",LOCAL_DATUM["Building",0],UNIT["metre",1],AXIS["x",OTHER],AXIS["y",OTHER]]',
  'metres in the frame of the building, x and y at a right angle, counter-clockwise');

CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY,
  data_type TEXT NOT NULL,
  identifier TEXT UNIQUE,
  description TEXT DEFAULT '',
  last_change DATETIME NOT NULL,
  min_x DOUBLE,
  min_y DOUBLE,
  max_x DOUBLE,
  max_y DOUBLE,
  srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));

CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL,
  column_name TEXT NOT NULL,
  geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL,
  m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents (table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));
)sql";

// exits.id and path_samples.id are asr * 2^32 + seq: one integer key, as GeoPackage asks, and an
// ASR's rows lie side by side without an index. REAL columns may be NULL: that is a NaN.
const char* const kMissionSql = R"sql(
CREATE TABLE metadata (
  id INTEGER PRIMARY KEY,
  key TEXT NOT NULL UNIQUE,
  value TEXT NOT NULL);

CREATE TABLE asr (
  id INTEGER PRIMARY KEY,
  room INTEGER NOT NULL,
  start_s REAL,
  end_s REAL,
  odom_from_asr_x_m REAL,
  odom_from_asr_y_m REAL,
  odom_from_asr_theta_rad REAL,
  reference_x_m REAL,
  reference_y_m REAL,
  outline_wkb BLOB NOT NULL,
  walls_wkb BLOB NOT NULL,
  edges_fitted TEXT NOT NULL,
  grid_cells INTEGER NOT NULL,
  grid_bytes INTEGER NOT NULL,
  occupied_cells INTEGER NOT NULL,
  cleaned_cells INTEGER NOT NULL,
  extracted_points INTEGER NOT NULL,
  vertices INTEGER NOT NULL,
  geometry_bytes INTEGER NOT NULL,
  ignored_ranges INTEGER NOT NULL,
  is_localized BOOLEAN NOT NULL);

CREATE TABLE exits (
  id INTEGER PRIMARY KEY,
  asr INTEGER NOT NULL,
  kind TEXT NOT NULL,
  is_entry BOOLEAN NOT NULL,
  asr_from_pivot_x_m REAL,
  asr_from_pivot_y_m REAL,
  asr_from_pivot_theta_rad REAL,
  width_m REAL,
  left_jamb_x_m REAL,
  left_jamb_y_m REAL,
  right_jamb_x_m REAL,
  right_jamb_y_m REAL,
  neighbor INTEGER,
  timestamp_s REAL);
CREATE INDEX exits_neighbor ON exits (neighbor) WHERE neighbor IS NOT NULL;

CREATE TABLE path_samples (
  id INTEGER PRIMARY KEY,
  asr INTEGER NOT NULL,
  seq INTEGER NOT NULL,
  timestamp_s REAL,
  asr_from_robot_x_m REAL,
  asr_from_robot_y_m REAL,
  asr_from_robot_theta_rad REAL,
  odom_from_robot_x_m REAL,
  odom_from_robot_y_m REAL,
  odom_from_robot_theta_rad REAL);

CREATE TABLE sensors (
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL,
  half_cone_rad REAL,
  max_range_m REAL,
  beam_count INTEGER NOT NULL,
  robot_from_beam BLOB NOT NULL);

CREATE TABLE readings (
  asr INTEGER PRIMARY KEY,
  reading_count INTEGER NOT NULL,
  raw_bytes INTEGER NOT NULL,
  deflated BLOB NOT NULL);

CREATE TABLE truth (
  id INTEGER PRIMARY KEY,
  timestamp_s REAL,
  world_from_robot_x_m REAL,
  world_from_robot_y_m REAL,
  world_from_robot_theta_rad REAL);
)sql";

std::string shapes_sql(const std::string& prefix) {
  const std::string create = "CREATE TABLE " + prefix;
  return create + R"sql(rooms (
  id INTEGER PRIMARY KEY,
  geom MULTIPOLYGON,
  name TEXT NOT NULL,
  kind TEXT NOT NULL,
  area_m2 REAL,
  label_x REAL,
  label_y REAL,
  asrs TEXT NOT NULL);
)sql" + create +
         R"sql(doors (
  id INTEGER PRIMARY KEY,
  geom POLYGON,
  width_m REAL,
  room_a INTEGER,
  room_b INTEGER,
  jamb_a_x REAL,
  jamb_a_y REAL,
  jamb_b_x REAL,
  jamb_b_y REAL,
  kind TEXT,
  leaf_hinge_x REAL,
  leaf_hinge_y REAL,
  leaf_end_x REAL,
  leaf_end_y REAL);
)sql" + create +
         R"sql(walls (id INTEGER PRIMARY KEY, geom POLYGON);
)sql" + create +
         R"sql(free_space (id INTEGER PRIMARY KEY, geom POLYGON);
)sql";
}

std::string edges_sql(const std::string& prefix) {
  return "CREATE TABLE " + prefix + R"sql(edges (
  id INTEGER PRIMARY KEY,
  geom LINESTRING,
  room INTEGER NOT NULL,
  evidence TEXT NOT NULL,
  deviation_m REAL);
)sql";
}

const char* const kResultSql = R"sql(
CREATE TABLE furniture (id INTEGER PRIMARY KEY, geom POLYGON, kind TEXT);
CREATE TABLE path (asr INTEGER PRIMARY KEY, geom LINESTRING);

CREATE TABLE assembly (
  id INTEGER PRIMARY KEY,
  title TEXT NOT NULL,
  converged BOOLEAN NOT NULL,
  model TEXT NOT NULL,
  message TEXT NOT NULL,
  initial_cost REAL,
  final_cost REAL,
  iterations INTEGER NOT NULL,
  heading_bias_rad_per_m REAL NOT NULL,
  heading_bias_rad_per_rad REAL NOT NULL,
  heading_bias_asrs INTEGER NOT NULL);

CREATE TABLE corrections (
  asr INTEGER PRIMARY KEY,
  component INTEGER NOT NULL,
  before_x_m REAL,
  before_y_m REAL,
  before_theta_rad REAL,
  after_x_m REAL,
  after_y_m REAL,
  after_theta_rad REAL,
  moved_m REAL,
  turned_rad REAL,
  chi_square_before REAL,
  chi_square_after REAL,
  cause TEXT,
  cause_asr INTEGER);

CREATE TABLE closures (
  id INTEGER PRIMARY KEY,
  from_asr INTEGER NOT NULL,
  to_asr INTEGER NOT NULL,
  x_m REAL,
  y_m REAL,
  theta_rad REAL,
  agreeing INTEGER NOT NULL,
  contradicting INTEGER NOT NULL,
  unseen INTEGER NOT NULL,
  score INTEGER NOT NULL,
  verdict TEXT NOT NULL,
  was_given BOOLEAN NOT NULL,
  information_xx REAL,
  information_xy REAL,
  information_xt REAL,
  information_yy REAL,
  information_yt REAL,
  information_tt REAL);

CREATE TABLE factors (
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL,
  from_asr INTEGER NOT NULL,
  to_asr INTEGER NOT NULL,
  chi_square_before REAL,
  chi_square_after REAL,
  weight REAL);

CREATE TABLE plan_issues (
  id INTEGER PRIMARY KEY,
  severity TEXT NOT NULL,
  file TEXT NOT NULL,
  line INTEGER NOT NULL,
  field TEXT NOT NULL,
  message TEXT NOT NULL);
)sql";

const char* const kMatchedPathSql = R"sql(
CREATE TABLE IF NOT EXISTS matched_path (
  id INTEGER PRIMARY KEY,
  asr_from_robot_x_m REAL,
  asr_from_robot_y_m REAL,
  asr_from_robot_theta_rad REAL);
)sql";

}  // namespace roomatlas
