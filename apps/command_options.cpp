// SPDX-License-Identifier: GPL-3.0-or-later
// One of the files that include CLI11.
#include "command_options.hpp"

#include <map>
#include <string>

#include "command_notes.hpp"
#include "limits.hpp"

namespace roomatlas::apps {

namespace {

/// A folder's name may end in slashes; behind the last there would be no name.
CLI::Validator without_slashes() {
  const auto cut = [](std::string& place) {
    while (place.size() > 1 && place.ends_with('/')) place.pop_back();
    return std::string();
  };
  return {cut, ""};
}

}  // namespace

CLI::Option* folder_or_file(CLI::Option* option) { return option->transform(without_slashes()); }

CLI::Option* positional(CLI::App* command, const char* name, Path& value, const char* meaning) {
  CLI::Option* option = command->add_option(name, value, meaning);
  return folder_or_file(option)->type_name("FILE")->required()->configurable(false);
}

CLI::Option* positionals(CLI::App* command, const char* name, std::vector<Path>& values,
                         const char* meaning) {
  CLI::Option* option = command->add_option(name, values, meaning);
  return folder_or_file(option)->type_name("FILE")->required()->configurable(false);
}

CLI::Option* output(CLI::App* command, Path& value, const char* meaning) {
  CLI::Option* option = command->add_option("-o,--output", value, meaning);
  return option->type_name("FILE")->required()->configurable(false);
}

CLI::Option* output_folder(CLI::App* command, Path& value, const char* meaning) {
  return folder_or_file(output(command, value, meaning))->type_name("FOLDER");
}

void add_export_options(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--georef", options.georef,
                   "latitude, longitude, heading: where the plan's origin is, and the compass "
                   "direction of its "
                   "y axis, in deg; plan.geojson is then on the earth")
      ->delimiter(',')
      ->expected(3)
      ->type_name("LAT,LON,DEG")
      ->configurable(false);
  command
      ->add_option(
          "--north", options.north,
          "deg, clockwise from the plan's y axis: where north is; as --georef says without it")
      ->check(within(-360.0, 360.0))
      ->type_name("DEG")
      ->configurable(false);
}

void add_measured_walls(CLI::App* command, ExportOptions& options) {
  command
      ->add_flag("--measured-walls", options.measured_walls,
                 "the walls as measured, where `assemble` made them regular")
      ->configurable(false);
}

void add_ogr_option(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--ogr", options.ogr_driver,
                   "vector format of GDAL for -f ogr, such as GML or \"ESRI Shapefile\"")
      ->type_name("FORMAT")
      ->configurable(false);
}

void add_address_option(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--address", options.address,
                   "of the building, for -f imdf: \"STREET;CITY;COUNTRY\" or "
                   "\"STREET;CITY;COUNTRY;POSTCODE\", the country as ISO 3166 has it")
      ->type_name("ADDRESS")
      ->configurable(false);
}

void add_storey_height(CLI::App* command, ExportOptions& options) {
  command
      ->add_option("--storey-height", options.storey_height_m,
                   "m, of rooms and walls in -f ifc: nothing measures it")
      ->check(within(2.0, 20.0))
      ->capture_default_str()
      ->type_name("M")
      ->configurable(false);
}

void add_truth(CLI::App* command, TruthArguments& arguments) {
  command
      ->add_option(
          "--truth", arguments.truth,
          "truth to compare with: FILE.relations, a trajectory (TUM, g2o, CARMEN log with "
          "TRUEPOS, corrected log, poses), a plan FILE.geojson, a label picture "
          "FILE.pgm[.gz], or tape-measure spans FILE.csv; again for more. Of one of several "
          "missions: MISSION=FILE, with its name or number")
      ->type_name("FILE")
      ->configurable(false);
  command
      ->add_option("--spans", arguments.spans, "tape-measure spans, FILE.csv: as --truth FILE.csv")
      ->type_name("FILE")
      ->configurable(false);
  add_trajectory_flags(command, arguments.trajectory);
}

namespace {

/// How the simulated robot drives, and where it is carried.
void add_drive(CLI::App* command, SimulateArguments& a) {
  command->add_option("--drive", a.drive, "way-points; without them the robot explores by itself")
      ->type_name("FILE")
      ->configurable(false);
  command->add_flag("--tour", a.tour, "drive through all rooms as somebody who knows them would")
      ->configurable(false);
  command
      ->add_option("--start", a.start, "where the exploring robot starts: x,y in m, heading in deg")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->type_name("X,Y,DEG")
      ->configurable(false);
  command
      ->add_option(
          "--carry-at", a.carry_at_s,
          "s; the robot is carried away then (of a tour: at the way-point before), and drives "
          "on from --carry-to")
      ->check(within(1.0, 1e6))
      ->type_name("S")
      ->configurable(false);
  command
      ->add_option("--carry-to", a.carry_to,
                   "where to: x,y in m, heading in deg; odometry goes on as if nothing was")
      ->delimiter(',')
      ->expected(3)
      ->check(finite())
      ->type_name("X,Y,DEG")
      ->configurable(false);
}

}  // namespace

void add_simulate(CLI::App* command, SimulateArguments& a) {
  command->add_option("WORLD", a.world, "plan (GeoJSON), nav2 map (YAML), or picture (PNG, PGM)")
      ->type_name("FILE")
      ->configurable(false);
  command
      ->add_option("--random-rooms", a.random_rooms,
                   "instead of WORLD: a random building of N rooms, as a store of ASRs")
      ->type_name("N")
      ->configurable(false);
  command
      ->add_option("--random-world", a.random_world,
                   "instead of WORLD: a building that this seed makes up")
      ->type_name("SEED")
      ->configurable(false);
  command->add_option("--world-kind", a.world_kind, "of --random-world: offices, hall, wings ...")
      ->type_name("KIND")
      ->configurable(false);
  command->add_option("--world-rooms", a.world_rooms, "of --random-world: about so many, 3 to 40")
      ->type_name("N")
      ->configurable(false);
  command
      ->add_option("--resolution", a.file.resolution_m, "m a pixel, of a world that is a picture")
      ->check(within(0.001, 10.0))
      ->type_name("M")
      ->configurable(false);
  command->add_option("--room-labels", a.file.room_labels, "picture with each pixel's room number")
      ->type_name("FILE")
      ->configurable(false);
  add_drive(command, a);
  command->add_option("--furnish", a.furnish, "seed of furniture and open doors that are put in")
      ->type_name("SEED")
      ->configurable(false);
  command->add_option("--format", a.format, "of the mission: CARMEN, or topics")
      ->check(CLI::IsMember({"clf", "bag", "mcap", "db3"}))
      ->configurable(false);
  output_folder(command, a.out, "folder for mission.clf, truth.tum and truth.geojson");
}

void add_comparison_files(CLI::App* command, ComparisonFiles& files) {
  const auto add = [&](const char* name, Path& value, const char* meaning) {
    return command->add_option(name, value, meaning)
        ->type_name("FILE")
        ->group(kResults)
        ->configurable(false);
  };
  add("--csv", files.csv, "file for all figures, a line each");
  add("--latex", files.latex, "file for a table with means and intervals");
  add("--plots", files.plots, "folder for SVG plots: over time, histogram, map")
      ->type_name("FOLDER");
  add("--archive", files.archive, "ZIP file in evo's result layout");
}

void add_optimize(CLI::App* command, OptimizeArguments& a) {
  positional(command, "GRAPH", a.graph, "pose graph: g2o or TORO, plain or gzip");
  output(command, a.out, "g2o file to write");
  command->add_flag("--robust", a.options.robust, "reject closures that contradict the others")
      ->configurable(false);
  command->add_flag("--strict", a.strict, "exit code 5 where the result should not be trusted")
      ->configurable(false);
  command->add_option("--covariance", a.covariance, "CSV file to write covariances to")
      ->type_name("FILE")
      ->configurable(false);
  command->add_option("--solver", a.options.solver, "block, or ceres: the reference, slower")
      ->transform(CLI::CheckedTransformer(std::map<std::string, PoseGraphSolver>{
          {"block", PoseGraphSolver::block}, {"ceres", PoseGraphSolver::ceres}}))
      ->configurable(false);
}

void add_locate(CLI::App* command, LocateArguments& a) {
  positional(command, "STORE", a.building, "assembled store of the building");
  positional(command, "LOG", a.log, "mission log; a few metres of path are enough");
  command
      ->add_option("--from", a.from_s, "s, as in the log: where the span begins that is looked for")
      ->check(finite())
      ->type_name("S")
      ->configurable(false);
  command->add_option("--to", a.to_s, "s, as in the log: where it ends")
      ->check(finite())
      ->type_name("S")
      ->configurable(false);
  command
      ->add_option("-o,--output", a.out,
                   "TUM file for the pose of each reading in the building; written where the place "
                   "is sure")
      ->type_name("FILE")
      ->configurable(false);
}

void add_compare(CLI::App* command, CompareArguments& a) {
  positional(command, "OLD", a.before, "assembled store of the older mission");
  positional(command, "NEW", a.after, "assembled store of the newer mission");
  CLI::Option* pose =
      command->add_option("--old-from-new", a.old_from_new,
                          "about where the new building's frame lies in the old one; else near it");
  pose->type_name("X,Y,DEG")->delimiter(',')->expected(3)->check(finite())->configurable(false);
  output_folder(command, a.out,
                "folder for changes.svg, changes.png, changes.geojson and changes.csv");
}

}  // namespace roomatlas::apps
