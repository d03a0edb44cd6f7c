// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_case.hpp"

#include <cstdio>
#include <string>

#include "draw.hpp"

namespace roomatlas::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kGeneratedShare = 0.7;  // of buildings; the rest are real plans
constexpr std::uint64_t kTurns = 10;     // cases, of which the last is a recorded log
constexpr double kRareLog = 0.1;         // how often the long one is taken
constexpr double kLabelledShare = 0.9;   // of real plans; the rest have no rooms told

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all = {"offices",     "long_corridor", "ring",
                                               "equal_rooms", "hall",          "open_plan",
                                               "apartment",   "wings",         "rotunda"};
  return all;
}

const std::vector<std::string>& labelled_maps() {
  static const std::vector<std::string> all = {
      "Freiburg52_scan", "Freiburg79_scan", "NLB",      "lab_a_scan", "lab_b_scan",
      "lab_c_scan",      "lab_d_scan",      "office_a", "office_c",   "office_d",
      "office_f",        "office_g",        "office_i"};
  return all;
}

/// A nav2 map that has no rooms, from which a start could be told.
struct FloorPlanMap {
  std::string name;
  Words start;  ///< in the middle of its largest free square: x, y in metres, degrees
};

const std::vector<FloorPlanMap>& floor_plans() {
  static const std::vector<FloorPlanMap> all = {{"kth", {"-4.62", "-14.32", "0"}},
                                                {"uol_bl", {"-25.48", "6.82", "0"}},
                                                {"collection1-cropped", {"-39.6", "18.1", "0"}}};
  return all;
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Puts the words of one case together.
class Writer {
 public:
  Writer(Draw& draw, DrawnCase& drawn) : draw_(draw), drawn_(drawn) {}

  void building(const fs::path& data) {
    if (draw_.happens(kGeneratedShare)) return generated();
    if (draw_.happens(kLabelledShare)) return labelled(data);
    const FloorPlanMap& map = draw_.one_of(floor_plans());
    drawn_.building = map.name;
    word((data / "floorplans" / "navmaps" / (map.name + ".yaml")).string());
    word("--start");
    for (const std::string& number : map.start) word(number);
    drawn_.has_rooms = false;
  }

  /// A ring of few sonars, or a laser that sees little, would find no way by itself.
  void drive(bool finds_its_way) {
    const bool explores = !drawn_.has_rooms || (finds_its_way && draw_.happens(0.4));
    if (!explores) word("--tour");
    add("--max-time", draw_.whole(10, drawn_.stratum == Stratum::hard ? 18 : 25) * 60.0);
    add("--speed", draw_.between(0.3, 0.6));
  }

  void life() {
    if (drawn_.has_rooms && draw_.happens(0.5)) add("--furnish", draw_.whole(1, 100000));
    if (draw_.happens(0.4)) add("--people", draw_.whole(1, 6));
    if (draw_.happens(0.3)) add("--moving-doors", draw_.between(0.1, 0.7));
  }

  void laser(bool is_hard) {
    drawn_.sensor = "laser";
    add("--sensor", "laser");
    const bool sees_little = is_hard && draw_.happens(0.6);
    const bool is_coarse = is_hard && draw_.happens(0.6);
    const bool is_short = is_hard && draw_.happens(0.6);
    const std::vector<double> usual = {180.0, 180.0, 240.0, 270.0, 360.0};
    const double view_deg = sees_little ? draw_.between(60.0, 150.0) : draw_.one_of(usual);
    add("--laser-view", view_deg);
    add("--laser-beams",
        is_coarse ? draw_.whole(20, 60) : static_cast<int>(draw_.between_by_ratio(181.0, 1000.0)));
    add("--laser-range", is_short ? draw_.between(4.0, 6.0) : draw_.between(8.0, 30.0));
    add("--laser-noise", draw_.between(0.005, is_hard ? 0.05 : 0.03));
    add("--laser-dropout", draw_.between(0.0, 0.02));
    if (draw_.happens(0.5)) {
      const double share = draw_.between(0.0, is_hard ? 0.3 : 0.1);
      add("--laser-silent-walls", share);
      if (share > 0.15) fault("silent walls");
    }
    if (view_deg <= 270.0 && draw_.happens(is_hard ? 0.1 : 0.2)) {
      word("--laser-behind");
      drawn_.sensor = "two lasers";
      drawn_.format = "bag";
    }
    if (sees_little) fault("narrow view");
    if (is_coarse) fault("few beams");
    if (is_short) fault("short range");
  }

  void sonar(bool is_hard) {
    drawn_.sensor = "sonar";
    add("--sensor", "sonar");
    const int sonars = is_hard ? draw_.whole(3, 7) : draw_.whole(8, 16);
    add("--sonars", sonars);
    add("--sonar-opening", draw_.between(15.0, 30.0));
    add("--sonar-range", draw_.between(3.0, 6.0));
    add("--sonar-noise", draw_.between(0.005, is_hard ? 0.05 : 0.03));
    add("--sonar-dropout", draw_.between(0.0, is_hard ? 0.15 : 0.05));
    add("--sonar-specular", draw_.between(30.0, 50.0));
    add("--sonar-crosstalk", draw_.between(0.0, is_hard ? 0.06 : 0.02));
    if (is_hard) fault("few sonars");
  }

  void odometry(bool is_hard) {
    const bool drifts = is_hard && draw_.happens(0.5);
    add("--odometry-bias",
        draw_.either_sign(drifts ? draw_.between(3.0, 6.0) : draw_.between(0.0, 3.0)));
    add("--odometry-noise", draw_.between(0.5, is_hard ? 3.0 : 2.0));
    add("--odometry-length-error", draw_.either_sign(draw_.between(0.0, is_hard ? 0.05 : 0.04)));
    add("--odometry-turn-error", draw_.either_sign(draw_.between(0.0, is_hard ? 0.05 : 0.04)));
    if (drifts) fault("drift");
    if (!is_hard) return;
    if (draw_.happens(0.3)) rare("slip", "--odometry-slip", draw_.between(0.01, 0.06));
    if (draw_.happens(0.3)) rare("lag", "--odometry-lag", draw_.between(0.1, 0.5));
    if (draw_.happens(0.3)) rare("pushes", "--pushes", draw_.between(4.0, 20.0));
    if (draw_.happens(0.3)) rare("dropouts", "--encoder-dropouts", draw_.between(4.0, 20.0));
  }

 private:
  void generated() {
    drawn_.building = draw_.one_of(kinds());
    add("--random-world", draw_.whole(1, 1000000));
    add("--world-kind", drawn_.building);
    // Within its time the robot gets through about a dozen rooms; few buildings are larger.
    add("--world-rooms", draw_.happens(0.85) ? draw_.whole(3, 14) : draw_.whole(15, 40));
  }

  void labelled(const fs::path& data) {
    drawn_.building = draw_.one_of(labelled_maps());
    const std::string stem = (data / "rooms" / drawn_.building / drawn_.building).string();
    word(stem + ".pgm.gz");
    add("--room-labels", stem + "_gt_labels.pgm.gz");
    add("--resolution", 0.05);
  }

  void word(const std::string& text) { drawn_.simulate.push_back(text); }
  void add(const std::string& flag, const std::string& value) {
    // A negative number would be read as a flag.
    word(flag + "=" + value);
  }
  void add(const std::string& flag, double value) { add(flag, text_of(value)); }
  void add(const std::string& flag, int value) { add(flag, std::to_string(value)); }
  void fault(const std::string& name) { drawn_.faults.push_back(name); }
  void rare(const std::string& name, const std::string& flag, double value) {
    add(flag, value);
    fault(name);
  }

  Draw& draw_;
  DrawnCase& drawn_;
};

/// Altered in some of the ways in which a simulated mission is drawn.
void change_a_log(Draw& draw, DrawnCase& drawn) {
  LogChange& change = drawn.change;
  drawn.has_rooms = false;
  const bool is_rare = draw.happens(kRareLog);
  const std::vector<std::string> usual = {"fr079", "aces"};
  drawn.building = is_rare ? "mit-killian" : draw.one_of(usual);
  change.log = "logs/" + drawn.building + "/" + drawn.building +
               (is_rare ? ".reconstructed.clf.gz" : ".clf.gz");
  drawn.sensor = "laser";
  const auto fault = [&](const std::string& name, bool happens) {
    if (happens) drawn.faults.push_back(name);
    return happens;
  };
  if (fault("few beams", draw.happens(0.4))) {
    change.every_beam = static_cast<std::size_t>(draw.whole(2, 8));
  }
  if (fault("narrow view", draw.happens(0.25))) change.view_deg = draw.between(60.0, 150.0);
  if (fault("short range", draw.happens(0.4))) change.max_range_m = draw.between(4.0, 12.0);
  if (fault("range noise", draw.happens(0.4))) change.range_noise_m = draw.between(0.01, 0.05);
  if (fault("odometry", draw.happens(0.7))) {
    change.odometry.bias_deg_per_m = draw.either_sign(draw.between(0.0, 4.0));
    change.odometry.length_scale = 1.0 + draw.either_sign(draw.between(0.0, 0.05));
    change.odometry.turn_gain = 1.0 + draw.either_sign(draw.between(0.0, 0.05));
    change.odometry.noise_deg_per_sqrt_m = draw.between(0.0, 2.0);
  }
  if (fault("lag", draw.happens(0.15))) change.odometry.lag_s = draw.between(0.1, 0.5);
  change.seed = draw.whole(1, 1000000);
  if (fault("as sonar", draw.happens(0.2))) drawn.build.push_back("--as-sonar");
}

}  // namespace

const char* to_string(Stratum stratum) {
  switch (stratum) {
    case Stratum::laser:
      return "ordinary laser";
    case Stratum::sonar:
      return "ordinary sonar";
    case Stratum::hard:
      return "hard";
    case Stratum::recorded:
      return "recorded";
  }
  return "";
}

DrawnCase drawn_case(std::uint64_t seed, std::uint64_t number, const std::filesystem::path& data) {
  DrawnCase drawn;
  drawn.seed = seed;
  drawn.number = number;
  drawn.stratum =
      number % kTurns == kTurns - 1 ? Stratum::recorded : static_cast<Stratum>(number % kTurns % 3);
  const bool is_hard = drawn.stratum == Stratum::hard;
  Draw draw(seed, number);
  if (drawn.stratum == Stratum::recorded) {
    change_a_log(draw, drawn);
    return drawn;
  }
  Writer writer(draw, drawn);
  writer.building(data);
  const bool is_laser = is_hard ? draw.happens(0.5) : drawn.stratum == Stratum::laser;
  if (is_laser) {
    writer.laser(is_hard);
  } else {
    writer.sonar(is_hard);
  }
  writer.drive(!is_hard && is_laser);
  writer.life();
  writer.odometry(is_hard);
  drawn.simulate.push_back("--seed=" + std::to_string(draw.whole(1, 1000000)));
  return drawn;
}

}  // namespace roomatlas::bench
