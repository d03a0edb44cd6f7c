// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and their arguments: one of the files that include CLI11.
#include "command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bind_parameters.hpp"
#include "building_report.hpp"
#include "command_options.hpp"
#include "command_tree.hpp"
#include "commands.hpp"
#include "completion.hpp"
#include "console.hpp"
#include "help_page.hpp"
#include "limits.hpp"
#include "man_page.hpp"
#include "output_places.hpp"
#include "printable.hpp"
#include "wrong_usage.hpp"

namespace roomatlas::apps {
namespace {

/// Files and choices of the command in use.
struct Arguments {
  Path log;
  bool is_strict = false;
  bool is_forced = false;
  Path store;
  AsrId asr = 0;
  int alternative = 1;  ///< of several answers
  std::vector<std::string> missions;
  double resolution_m = 0.0;
  std::string edits;  ///< file of statements; empty: those that the store keeps
  std::string room;
  std::string name;
  Path out;
  SimulateArguments simulate;
  std::vector<Path> judged;
  TruthArguments truth;
  ComparisonFiles comparison;
  ExportOptions exported;
  std::vector<std::string> formats = export_formats();
  bool print_config = false;
  OptimizeArguments optimize;
  CompareArguments compare;
  LocateArguments locate;
  std::string shell;
  ManArguments man;
};

/// Help pages, instead of those of CLI11.
class HelpPages : public CLI::FormatterBase {
 public:
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string /*name*/,
                                      CLI::AppFormatMode mode) const override {
    const HelpSize size = mode == CLI::AppFormatMode::All ? HelpSize::all : HelpSize::page;
    const CLI::App* program = app->get_parent() == nullptr ? app : app->get_parent();
    const ProgramText text = text_of(*program);
    return app == program ? help_of(text, size) : help_of(text.command(app->get_name()), size);
  }
};

/// The commands with their files; what runs is left in `chosen`.
class Commands {
 public:
  Commands(CLI::App& app, const Settings& settings, Arguments& arguments,
           std::function<void()>& chosen)
      : app_(app), settings_(settings), a_(arguments), chosen_(chosen) {}

  void add_all() {
    add_stages();
    add_joins();
    add_results();
    add_tools();
  }

 private:
  CLI::App* command(const char* name, const char* meaning, std::function<void()> run) {
    CLI::App* sub = app_.add_subcommand(name, meaning)->fallthrough()->configurable(false);
    sub->callback([this, run = std::move(run)] { chosen_ = run; });
    return sub;
  }

  /// From a log to a plan.
  void add_stages() {
    CLI::App* info = command("info", "what is in a log", [this] { apps::info(settings_, a_.log); });
    positional(info, "LOG", a_.log, "mission log");

    CLI::App* build = command("build", "log or map -> floor plan: everything in order", [this] {
      apps::build(edited(), {a_.judged, a_.resolution_m, a_.out, a_.truth.files(),
                             a_.truth.trajectory, a_.exported, a_.is_strict});
    });
    positionals(
        build, "LOG|MAP", a_.judged,
        "mission log, plain or gzip; several of one building are joined; or a finished map: "
        "nav2 YAML, or PNG or PGM");
    build->add_option("--resolution", a_.resolution_m, "m a pixel, of a map that is a picture")
        ->check(within(0.001, 10.0))
        ->type_name("M")
        ->configurable(false);
    output_folder(build, a_.out, "folder for the results");
    add_truth(build, a_.truth);
    add_export_options(build, a_.exported);
    add_edits(build);
    add_force(build);
    build->add_flag("--strict", a_.is_strict, "exit code 5 where the map is doubtful")
        ->configurable(false);

    CLI::App* map = command("map", "online stage: log -> rooms in a store", [this] {
      const PlaceLock lock = lock_new_store(a_.out, {a_.log});
      map_and_tell(forced(), a_.log, a_.out);
    });
    positional(map, "LOG", a_.log, "mission log, plain or gzip");
    output(map, a_.out, "store to write, such as building.gpkg");
    add_force(map);

    CLI::App* assemble =
        command("assemble", "offline stage: graph, correction, floor plan", [this] {
          const PlaceLock lock = lock_store(a_.store);
          const std::size_t rooms = assemble_again(edited(), a_.store, a_.alternative, a_.missions);
          if (settings_.json) tell_assembled(settings_, a_.store);
          require_a_room(rooms, a_.store);
        });
    positional(assemble, "STORE", a_.store, "store to complete");
    assemble
        ->add_option("--alternative", a_.alternative,
                     "which answer is drawn where several explain the readings nearly as well")
        ->check(within(1, 9))
        ->capture_default_str()
        ->configurable(false);
    assemble
        ->add_option(
            "--missions", a_.missions,
            "of a building of several: draw what these alone saw (names or numbers, separated "
            "by commas)")
        ->delimiter(',')
        ->configurable(false);
    add_edits(assemble);
  }

  [[nodiscard]] Settings edited() const {
    Settings settings = forced();
    settings.edits_file = a_.edits;
    return settings;
  }
  [[nodiscard]] Settings forced() const {
    Settings settings = settings_;
    settings.force = a_.is_forced;
    return settings;
  }

  void add_force(CLI::App* sub) {
    sub->add_flag("--force", a_.is_forced,
                  "map from the log's begin, in the place of whatever store is there")
        ->configurable(false);
  }

  void add_edits(CLI::App* sub) {
    sub->add_option("--edits", a_.edits,
                    "edits.json: corrections by hand, which the store then keeps")
        ->configurable(false);
  }

  /// Several missions of one building.
  void add_joins() {
    CLI::App* join = command("join", "stores of several missions -> one building",
                             [this] { apps::join(settings_, a_.judged, a_.out); });
    positionals(join, "STORE", a_.judged,
                "assembled stores of missions, or of what was joined already");
    output(join, a_.out, "store to write, such as building.gpkg");

    CLI::App* locate = command("locate", "where in a building the robot of a log was",
                               [this] { apps::locate(settings_, a_.locate); });
    add_locate(locate, a_.locate);
  }

  /// What is done with a plan.
  void add_results() {
    CLI::App* exported = command("export", "store -> drawings and files", [this] {
      export_and_tell(settings_, a_.store, a_.formats, a_.exported, a_.out);
    });
    positional(exported, "STORE", a_.store, "assembled store");
    exported->add_option("-f,--format", a_.formats, "formats, separated by commas")
        ->delimiter(',')
        ->capture_default_str()
        ->configurable(false);
    output_folder(exported, a_.out, "folder for the files");
    add_export_options(exported, a_.exported);
    add_ogr_option(exported, a_.exported);
    add_address_option(exported, a_.exported);
    add_storey_height(exported, a_.exported);
    add_measured_walls(exported, a_.exported);

    CLI::App* evaluate =
        command("evaluate", "errors of stores, trajectories or logs, against truth and without any",
                [this] {
                  apps::evaluate(settings_, a_.judged, a_.truth.files(), a_.truth.trajectory,
                                 a_.comparison);
                });
    positionals(
        evaluate, "RUN", a_.judged,
        "what to judge: an assembled store, a trajectory (TUM, g2o, poses) or a log; several "
        "are compared with the first");
    add_truth(evaluate, a_.truth);
    add_comparison_files(evaluate, a_.comparison);

    add_compare(command("compare", "what changed between two missions in one building",
                        [this] { apps::compare(settings_, a_.compare); }),
                a_.compare);

    CLI::App* report =
        command("report", "a page to look at in a browser: map, rooms, correction, errors", [this] {
          apps::report(settings_, a_.store, a_.truth.files(), a_.truth.trajectory, a_.out);
        });
    positional(report, "STORE", a_.store, "assembled store");
    output(report, a_.out, "HTML file to write, such as report.html");
    add_truth(report, a_.truth);

    CLI::App* rename = command("rename", "gives a room a name, which later plans keep",
                               [this] { apps::rename(settings_, a_.store, a_.room, a_.name); });
    positional(rename, "STORE", a_.store, "assembled store");
    rename->add_option("ROOM", a_.room, "its number or present name")
        ->required()
        ->configurable(false);
    rename->add_option("NAME", a_.name, "its new name")->required()->configurable(false);

    CLI::App* inspect = command("inspect", "one room as it was made, step by step, as a drawing",
                                [this] { apps::inspect(settings_, a_.store, a_.asr, a_.out); });
    positional(inspect, "STORE", a_.store, "store with readings");
    inspect->add_option("ASR", a_.asr, "its number")->required()->configurable(false);
    output_folder(inspect, a_.out, "folder for asr_N.svg and asr_N.png");
  }

  void add_tools() {
    add_simulate(command("simulate", "a robot in a known world: log with ground truth",
                         [this] { apps::simulate(settings_, a_.simulate); }),
                 a_.simulate);

    CLI::App* convert =
        command("convert", "log -> another format: what would be mapped, and nothing else",
                [this] { apps::convert(settings_, a_.log, a_.out); });
    positional(convert, "LOG", a_.log, "mission log, or recording of topics");
    folder_or_file(output(convert, a_.out,
                          "file to write: .mcap, .bag, .db3 or .clf; or a folder for a rosbag2"));

    add_optimize(command("optimize", "the solver alone, on a planar pose graph",
                         [this] { apps::optimize(settings_, a_.optimize); }),
                 a_.optimize);

    CLI::App* config = command("config", "the parameters as a configuration file (TOML)", [this] {
      if (settings_.json) {
        throw UsageError("config prints TOML: leave --json away");
      }
      fmt::print("{}", app_.config_to_str(true, true));
    });
    config->add_flag("--print", a_.print_config, "print every parameter with default and meaning")
        ->configurable(false);
    add_for_scripts();
  }

  /// What is written from the same definition as the help.
  void add_for_scripts() {
    CLI::App* completions =
        command("completion", "what a shell reads to complete commands and options",
                [this] { fmt::print("{}", completion(text_of(app_), a_.shell)); });
    completions->add_option("SHELL", a_.shell, "the shell")
        ->required()
        ->check(CLI::IsMember(completion_shells()))
        ->configurable(false);

    CLI::App* manual = command("man", "the manual as man(1) reads it",
                               [this] { apps::man(text_of(app_), a_.man); });
    manual->add_option("COMMAND", a_.man.command, "whose page; without it the program's")
        ->configurable(false);
    manual->add_option("-o,--output", a_.man.out, "folder for the pages of all commands")
        ->type_name("FOLDER")
        ->configurable(false);
  }

  CLI::App& app_;
  const Settings& settings_;
  Arguments& a_;
  std::function<void()>& chosen_;
};

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app("Roomatlas: from a finished robot mission to a building map that a person can read",
               "roomatlas");
  Settings settings;
  Arguments arguments;
  std::function<void()> chosen;
  app.formatter(std::make_shared<HelpPages>());
  app.set_help_flag("-h,--help", "the most wanted options, on one page");
  app.set_help_all_flag("--help-all", "all options and parameters");
  app.set_version_flag("--version", ROOMATLAS_VERSION, "the release");
  add_configuration_file(app);
  app.allow_config_extras(false);
  app.require_subcommand(1);
  app.add_flag("--json", settings.json, "one JSON object on stdout")->configurable(false);
  app.add_flag("-q,--quiet", settings.quiet, "errors alone; on stdout nothing but --json")
      ->configurable(false);
  app.add_flag("-v,--verbose", settings.verbose, "more on stderr")->configurable(false);
  bind_parameters(app, settings);
  Commands commands(app, settings, arguments, chosen);
  commands.add_all();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help and --version
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}", printable_lines(explain(app, error)));
    return kUsage;
  }
  complete(settings, app);
  set_up_console(settings);
  chosen();
  return kOk;
}

}  // namespace roomatlas::apps
