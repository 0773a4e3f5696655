// SPDX-License-Identifier: BSD-3-Clause
// `tolman eval` gives the figures of other tools: the rows of evo_reference/expected, each with the
// options that docs/evaluation.md names for it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/eval_scoring.hpp"
#include "evaluation/trajectory.hpp"
#include "support/data.hpp"

using namespace tolman;

namespace {

struct Row {
  std::string tool, metric, options, truth, estimate, value;
};

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) fields.emplace_back();
    if (c != '"' && (c != ',' || quoted)) fields.back() += c;
  }
  return fields;
}

std::vector<Row> rowsOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<Row> rows;
  std::string line;
  for (std::getline(stream, line); std::getline(stream, line);) {
    const auto f = fieldsOf(line);
    rows.push_back({f[0], f[2], f[3], f[4], f[5], f[6]});
  }
  REQUIRE(rows.size() > 6000);
  return rows;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The word after `option`; empty without it.
std::string after(const std::vector<std::string>& words, const std::string& option) {
  const auto found = std::ranges::find(words, option);
  return found == words.end() || found + 1 == words.end() ? "" : *(found + 1);
}

/// The options of eval for those of evo.
std::string ofEvo(const std::string& options) {
  const std::vector<std::string> words = wordsOf(options);
  const auto has = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
  std::string mine = "--like evo";
  if (has("-a")) mine += has("-s") ? " --align sim3" : " --align se3";
  if (has("-s") && !has("-a")) mine += " --scale sim3";
  if (has("--align_origin")) mine += " --align origin";
  const std::array same = {std::pair("--n_to_align", "--first"),
                           std::pair("--t_max_diff", "--max-difference"),
                           std::pair("--t_offset", "--offset"), std::pair("--t_start", "--from"),
                           std::pair("--t_end", "--until")};
  for (const auto& [theirs, ours] : same) {
    if (has(theirs)) mine += fmt::format(" {}={}", ours, after(words, theirs));
  }
  if (words[0] == "evo_ape") return mine;
  const std::string unit = after(words, "-u");
  mine += " --rpe " + after(words, "-d") + (unit == "d" ? "deg" : unit);
  if (!has("--all_pairs")) mine += " --pairs consecutive";
  return has("--pairs_from_reference") ? mine + " --path-of truth" : mine;
}

std::string ofKitti(const std::string& options) {
  const std::string align = after(wordsOf(options), "--align");
  const std::string mine = "--like kitti --rpe 1";
  if (align == "scale") return mine + " --scale fit";
  if (align == "scale_7dof") return mine + " --scale sim3";
  return mine + (align == "6dof" ? " --align se3" : align == "7dof" ? " --align sim3" : "");
}

std::string ofTum(const std::string& tool, const std::string& options) {
  const std::vector<std::string> words = wordsOf(options);
  std::string mine = fmt::format("--like tum --offset={} --scale {}", after(words, "--offset"),
                                 after(words, "--scale"));
  if (tool == "evaluate_ate_scale")
    mine = fmt::format("--like tum --align sim3 --offset={}", after(words, "--offset"));
  if (tool != "TUM evaluate_rpe.py")
    return mine + " --max-difference " + after(words, "--max_difference");
  return mine + " --rpe " + after(words, "--delta") + after(words, "--delta_unit");
}

std::string ofRpg(const std::string& options) {
  const auto between = [&](const std::string& key) {
    const auto begin = options.find(key + ": ") + key.size() + 2;
    return options.substr(begin, options.find(',', begin) - begin);
  };
  const std::string align = between("align_type"), first = between("align_num_frames");
  std::string mine = "--like rpg --align " + (align == "posyaw" ? "yaw" : align);
  return first == "-1" ? mine : mine + " --first " + first;
}

std::string ofOwn(const std::string& options) {
  return "--match interpolate --max-difference 5 --align " + options.substr(options.rfind(' ') + 1);
}

/// The options of eval for a row; empty where eval does not claim it.
std::string optionsFor(const Row& row) {
  if (row.value.starts_with("ERROR") || row.options.find("[WRONG") != std::string::npos) return "";
  if (row.tool == "evo") return ofEvo(row.options);
  if (row.tool == "kitti-odom-eval") return ofKitti(row.options);
  if (row.tool == "KITTI devkit C++") return "--like devkit";
  if (row.tool == "rpg_trajectory_evaluation") {
    const bool is_ate = row.metric.starts_with("ate_") || row.metric == "alignment_scale";
    return is_ate ? ofRpg(row.options) : "";
  }
  if (row.tool.starts_with("own")) {
    return row.options.starts_with("reference interpolated") ? ofOwn(row.options) : "";
  }
  return ofTum(row.tool, row.options);
}

double statisticOf(const evaluation::Statistics& s, const std::string& metric) {
  if (metric.find("mean") != std::string::npos) return s.mean;
  if (metric.find("median") != std::string::npos) return s.median;
  return metric.find("max") != std::string::npos ? s.max : s.rmse;
}

/// The figure of eval that a row is of.
double figureOf(const evaluation::Scores& scores, const std::string& metric) {
  if (metric == "alignment_scale") return scores.scale;
  if (metric.starts_with("t_rel") || metric.starts_with("r_rel")) {
    const bool is_all = metric == "t_rel" || metric == "r_rel";
    const double length = is_all ? 0 : std::stod(metric.substr(6));
    for (const auto& mean : scores.kitti.table) {
      if (mean.length_m == length)
        return metric[0] == 't' ? mean.t_rel_percent : mean.r_rel_deg_per_100m;
    }
    return metric[0] == 't' ? scores.kitti.t_rel_percent : scores.kitti.r_rel_deg_per_100m;
  }
  const bool is_rotation = metric.find("_rot") != std::string::npos;
  if (!metric.starts_with("rpe")) {
    return statisticOf(is_rotation ? scores.rotation_deg : scores.ate_m, metric);
  }
  const evaluation::RelativeError& steps = scores.steps.at(0);
  if (metric.find("pointdistratio") != std::string::npos)
    return statisticOf(steps.length_percent, metric);
  if (metric.find("pointdist") != std::string::npos) return statisticOf(steps.length_m, metric);
  return statisticOf(is_rotation ? steps.rotation_deg : steps.translation_m, metric);
}

/// Six digits; rotations of KITTI's text are orthonormal to 8e-7.
double toleranceOf(const Row& row) {
  return row.truth.find("kitti") != std::string::npos ? 5e-6 : 1e-6;
}

struct Files {
  std::filesystem::path folder;
  std::map<std::string, evaluation::Trajectory> read{};
  const evaluation::Trajectory& of(const std::string& name, bool as_written) {
    const bool is_kitti = name.find("kitti") != std::string::npos;
    const auto path = is_kitti ? folder / std::filesystem::path(name).filename()
                               : folder / "expected" / "inputs" / name;
    const std::string key = name + (as_written ? " as written" : "");
    if (!read.contains(key)) read[key] = evaluation::readTrajectory(path, as_written).value();
    return read[key];
  }
};

}  // namespace

TEST_CASE("eval gives the figures of evo, KITTI, TUM and rpg with its options", "[data]") {
  const auto folder = test::dataOrSkip("evo_reference");
  if (!folder) return;
  Files files{*folder};
  std::map<std::string, evaluation::Scores> known;
  struct Count {
    int all = 0, equal = 0;
  };
  std::map<std::string, Count> counts;
  std::vector<std::string> missed;
  for (const Row& row : rowsOf(*folder / "expected" / "expected.csv")) {
    const std::string options = optionsFor(row);
    if (options.empty()) continue;
    const std::string key = row.truth + " " + row.estimate + " " + options;
    if (!known.contains(key)) {
      app::EvalOptions given;
      CLI::App command;
      given.addTo(command);
      std::vector<std::string> words = wordsOf(options);
      std::ranges::reverse(words);
      command.parse(words);
      const bool as_written = given.readsMatrices();
      known[key] =
          *app::evaluate(given, files.of(row.truth, as_written), files.of(row.estimate, as_written),
                         row.truth, row.estimate, false)
               .metrics.scores;
    }
    const double value = std::stod(row.value), mine = figureOf(known[key], row.metric);
    const bool is_equal = std::fabs(mine - value) - 1e-9 <= toleranceOf(row) * std::fabs(value);
    for (const char* of : {row.tool.c_str(), row.tool.starts_with("own") ? "own" : "all"}) {
      ++counts[of].all;
      counts[of].equal += is_equal ? 1 : 0;
    }
    if (!is_equal && missed.size() < 20) {
      missed.push_back(fmt::format("{} {} with {}, {} {}: {} instead of {}", row.tool, row.metric,
                                   options, row.truth, row.estimate, mine, value));
    }
  }
  for (const auto& [tool, count] : counts) {
    CAPTURE(tool, count.all, count.equal, missed);
    CHECK(count.equal >= 0.97 * count.all);
  }
  CHECK(counts["all"].all > 5000);
}
