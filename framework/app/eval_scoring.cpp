// SPDX-License-Identifier: BSD-3-Clause
#include "app/eval_scoring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/options.hpp"
#include "base/text_file.hpp"
#include "config/text.hpp"
#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"

namespace tolman::app {
namespace {

using evaluation::Matching;
using evaluation::MatchRule;
using evaluation::Protocol;
using evaluation::Trajectory;

constexpr double kNanoseconds = 1e9;  // of a second

template <class T>
T named(const std::string& name, T otherwise) {
  return name.empty() ? otherwise : *config::valueNamed<T>(name);
}

double numberOf(const std::string& text, const std::string& option) {
  const auto value = text_encoding::parseNumber(text);
  if (!value) fail(ExitCode::Usage, option + ": '" + text + "' is not a number");
  return *value;
}

/// "10m", "10 m", "1deg", "5" (frames).
evaluation::Steps stepsOf(const std::string& text) {
  const std::size_t unit = std::min(text.find_first_not_of("0123456789.eE"), text.size());
  evaluation::Steps steps;
  steps.length = numberOf(text.substr(0, unit), "--rpe");
  const std::string name = text.substr(std::min(text.find_first_not_of(' ', unit), text.size()));
  using evaluation::StepUnit;
  steps.unit = name == "m"                   ? StepUnit::Metres
               : name == "s"                 ? StepUnit::Seconds
               : name == "deg"               ? StepUnit::Degrees
               : name.empty() || name == "f" ? StepUnit::Frames
                                             : StepUnit::Poses;
  if (steps.unit == StepUnit::Poses || !(steps.length > 0)) {
    fail(ExitCode::Usage, "--rpe: '" + text + "' is no step: give 10 (frames), 1s, 10m or 5deg");
  }
  return steps;
}

/// Poses that are matched by their order: refuses where their numbers show that poses of equal
/// number are of different times, warns where that may be so.
void checkOrder(const Trajectory& truth, const Trajectory& estimate, const std::string& truth_name,
                const std::string& name, std::vector<std::string>& warnings) {
  const int with_stamps = evaluation::hasStamps(truth) + evaluation::hasStamps(estimate);
  if (with_stamps == 2) {
    warnings.push_back(fmt::format(
        "{}: its stamps and those of {} have no moment in common; the poses are matched by their "
        "order",
        name, truth_name));
  }
  if (truth.size() == estimate.size() || truth.size() < 2 || estimate.size() < 2) return;
  const std::string counts =
      fmt::format("{} has {} poses and {} has {}", name, estimate.size(), truth_name, truth.size());
  if (with_stamps == 1) {  // at another rate all errors would be wrong
    fail(ExitCode::Dataset,
         counts +
             ", and only one of them has times: which belong together is not known; give both "
             "with times (TUM), or both as KITTI files that begin at the same frame");
  }
  warnings.push_back(counts +
                     ": pose N of one is compared with pose N of the other, so both must begin at "
                     "the same frame and leave none out; files with times (TUM) match by time");
}

/// Keeps the true poses between --from and --until.
Trajectory cropped(Trajectory truth, const EvalOptions& options) {
  std::erase_if(truth, [&](const auto& pose) {
    const double seconds = static_cast<double>(pose.stamp_ns) / kNanoseconds;
    return (options.from >= 0 && seconds < options.from) ||
           (options.until >= 0 && seconds > options.until);
  });
  return truth;
}

class Evaluator {
 public:
  Evaluator(const EvalOptions& options, const Trajectory& truth, const Trajectory& estimate,
            const std::string& truth_name, const std::string& name)
      : options_(options), truth_(cropped(truth, options)), estimate_(estimate) {
    std::vector<evaluation::Steps> steps;
    for (const std::string& each : options.rpe) {
      steps.push_back(stepsOf(each));
      steps.back().all = options.pairs == "all";
    }
    if (!options.offset.empty() && options.offset != "estimate") {
      delay(numberOf(options.offset, "--offset"));
    }
    const auto habit = named(options.like, evaluation::Habit::Tolman);
    protocol() = evaluation::protocolOf(habit, truth_, estimate_, std::move(steps));
    protocol().without_time = options.path;
    for (evaluation::Steps& each : protocol().steps) {
      if (!options.path_of.empty()) each.of_truth = options.path_of == "truth";
    }
    setMatching(truth_name, name);
    setAlignment();
  }

  Evaluated run(bool doubts) && {
    setClock();
    setBody();
    result_.metrics = evaluation::score(truth_, estimate_, protocol());
    if (!result_.metrics.scores) fail(ExitCode::Dataset, result_.metrics.reason);
    if (!doubts) return std::move(result_);
    result_.metrics.warning =
        evaluation::doubtText(evaluation::doubts(truth_, estimate_, protocol()));
    scoreParts();
    return std::move(result_);
  }

 private:
  Protocol& protocol() { return result_.protocol; }

  void delay(double seconds) {
    for (auto& pose : estimate_) pose.stamp_ns += std::llround(seconds * kNanoseconds);
  }

  void setMatching(const std::string& truth_name, const std::string& name) {
    Matching& matching = protocol().matching;
    const bool asks_time = options_.max_difference >= 0 || !options_.offset.empty() ||
                           (!options_.match.empty() && options_.match != "order");
    if (asks_time) {
      for (const auto& [path, file] : {std::pair(&truth_, &truth_name), {&estimate_, &name}}) {
        if (evaluation::hasStamps(*path) || path->size() < 2) continue;  // one may be at 0 s
        fail(ExitCode::Usage, *file +
                                  ": has no times, as all KITTI files; its poses can only be "
                                  "matched by their order");
      }
    }
    if (matching.rule == MatchRule::Order && asks_time) matching.rule = MatchRule::Nearest;
    matching.rule = named(options_.match, matching.rule);
    if (matching.rule == MatchRule::Interpolate) {
      matching.limit_ns = evaluation::usualGap(truth_);
    } else if (matching.limit_ns == 0) {
      matching.limit_ns = std::max<std::int64_t>(0, evaluation::usualDifference(truth_, estimate_));
    }
    if (options_.max_difference >= 0) {
      matching.limit_ns = std::llround(options_.max_difference * kNanoseconds);
    }
    if (matching.rule == MatchRule::Order && options_.match.empty()) {
      checkOrder(truth_, estimate_, truth_name, name, result_.warnings);
    }
  }

  void setAlignment() {
    evaluation::AlignmentRule& rule = protocol().alignment;
    rule.kind = named(options_.align, rule.kind);
    rule.first = options_.first;
    if (!options_.up.empty()) {
      rule.vertical = options_.up == "z" ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    }
    if (rule.kind != evaluation::Alignment::Yaw) rule.vertical = Eigen::Vector3d::UnitY();
    if (const auto scale = config::valueNamed<evaluation::ScaleRule>(options_.scale)) {
      rule.scale = *scale;
    } else if (!options_.scale.empty()) {
      const double factor = numberOf(options_.scale, "--scale");
      if (!(factor > 0)) fail(ExitCode::Usage, "--scale: give fit, sim3 or a number above 0");
      for (auto& pose : estimate_) pose.T_world_camera.translation() *= factor;
    }
  }

  evaluation::Matches matches() const {
    return valueOf(evaluation::associate(truth_, estimate_, result_.protocol.matching),
                   ExitCode::Dataset);
  }

  void setClock() {
    if (options_.offset != "estimate") return;
    const Matching wide{MatchRule::Nearest, 2'000'000'000};
    const auto found = valueOf(evaluation::associate(truth_, estimate_, wide), ExitCode::Dataset);
    result_.clock = evaluation::clockOffset(truth_, found);
    if (!result_.clock) {
      fail(ExitCode::Dataset, "the clock offset cannot be estimated: too few poses match");
    }
    delay(result_.clock->seconds);
  }

  /// The truth is then the path of the camera; positions alone: the estimate that of the body.
  void setBody() {
    if (options_.body.empty()) return;
    const bool asks = options_.body == "estimate";
    result_.body = asks ? evaluation::bodyOf(matches())
                        : valueOf(evaluation::parseBody(options_.body), ExitCode::Usage);
    if (!result_.body) {
      fail(ExitCode::Dataset,
           "the body of the truth cannot be estimated: too few poses match, or "
           "the truth has positions alone");
    }
    const Eigen::Isometry3d T_camera_body = result_.body->pose();
    if (evaluation::hasOrientations(truth_)) {
      truth_ = evaluation::ofBody(std::move(truth_), T_camera_body.inverse());
    } else {
      estimate_ = evaluation::ofBody(std::move(estimate_), T_camera_body);
    }
  }

  void scoreParts() {
    const evaluation::Matches all = matches();
    std::vector<std::size_t> begins = evaluation::restartsOf(all);
    if (begins.empty()) return;
    begins.insert(begins.begin(), 0);
    begins.push_back(all.size());
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
      const auto part = [&](const Trajectory& path) {
        return Trajectory(path.begin() + static_cast<std::ptrdiff_t>(begins[i]),
                          path.begin() + static_cast<std::ptrdiff_t>(begins[i + 1]));
      };
      result_.parts.push_back(evaluation::score(part(all.truth), part(all.estimate), protocol()));
    }
  }

  const EvalOptions& options_;
  Trajectory truth_;
  Trajectory estimate_;
  Evaluated result_;
};

}  // namespace

void EvalOptions::addTo(CLI::App& command) {
  addChoice(
      command, "--like", like, {"tolman", "evo", "kitti", "devkit", "tum", "rpg"},
      "Habits of another tool, for its number (docs/evaluation.md); other options change them");
  addChoice(command, "--align", align, {"none", "origin", "yaw", "se2", "se3", "sim3"},
            "Alignment before the comparison (default: se3)");
  addOption(command, "--first", first, "N", "Align the first N matched poses (default: all)");
  addOption(command, "--scale", scale, "FACTOR",
            "Multiply the estimate: a number, fit, or sim3 for the scale of that alignment");
  addChoice(command, "--up", up, {"y", "z"},
            "Vertical axis of --align yaw: y of the first camera (default), z of the world");
  addChoice(command, "--match", match, {"order", "nearest", "shorter", "each", "interpolate"},
            "Which poses are compared (default: nearest in time; without times their order)");
  addOption(command, "--max-difference", max_difference, "SECONDS",
            "Longest time between two poses that match (default: half a frame, at least 0.02); "
            "with interpolate between true poses (default: 2.5 usual steps)")
      ->check(notNegative)
      ->check(CLI::Range(0.0, 1e6));
  addOption(command, "--offset", offset, "SECONDS",
            "Added to the stamps of the estimate; estimate: found from the turns of both");
  addOption(command, "--from", from, "SECONDS", "Leave out true poses before this stamp")
      ->check(notNegative);
  addOption(command, "--until", until, "SECONDS", "Leave out true poses after this stamp")
      ->check(notNegative);
  addOption(command, "--body", body, "POSE",
            "Where the truth is measured, in the camera: x,y,z or x,y,z,qx,qy,qz,qw; estimate: "
            "found from the motions of both");
  addList(command, "--rpe", rpe, "STEP",
          "Relative errors over steps of this length: 10 (frames), 1s, 10m, 5deg");
  addChoice(command, "--pairs", pairs, {"all", "consecutive"},
            "Steps of --rpe from every pose, or one after the other (default: all)");
  addChoice(command, "--path-of", path_of, {"truth", "estimate"},
            "Whose metres and degrees --rpe counts (default: truth)");
  command.add_flag("--path", path, "Also distances between the paths without regard to time");
}

bool EvalOptions::readsMatrices() const {
  return evaluation::readsMatrices(named(like, evaluation::Habit::Tolman));
}

Evaluated evaluate(const EvalOptions& options, const Trajectory& truth, const Trajectory& estimate,
                   const std::string& truth_name, const std::string& name, bool doubts) {
  return Evaluator(options, truth, estimate, truth_name, name).run(doubts);
}

}  // namespace tolman::app
