// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "config/values.hpp"
#include "engine/provenance.hpp"
#include "evaluation/loops.hpp"
#include "experiment/bench.hpp"

namespace tolman::experiment {

bool isTurned(const PlaceObservation& seen) {
  return std::abs(wrapAngle(seen.relative_yaw)) > std::numbers::pi / 2;
}

Eigen::Isometry3d claimedPose(const PlaceObservation& seen) {
  return seen.has_relative_pose ? seen.T_template_current : fromPlanar({0, 0, seen.relative_yaw});
}

namespace {

/// Image `query` was recognised as the place of image `place`, from which the template was made.
struct Answer {
  evaluation::PlaceClaim claim;
  bool within_pass = true;  ///< both images are of the same pass
  bool turned = false;      ///< says that the place is passed in the opposite direction
};

/// One pass over the images of a source.
class Pass {
 public:
  Pass(engine::Assembly& assembly, const PlacesOptions& options, const Cancellation& cancellation)
      : assembly_(assembly), options_(options), cancellation_(cancellation) {}

  /// The pass (0 or 1) and the image in it from which a template was made.
  struct Template {
    int pass = 0;
    std::int64_t image = -1;
  };
  /// Adds the templates of this pass to `made_at`, by their ids.
  void show(int pass, std::map<std::int64_t, Template>& made_at) {
    const auto frame_done = options_.progress(assembly_.sourceInfo().frames);
    Frame frame;
    while (next(frame)) {
      const PlaceObservation seen = observe(frame);
      if (seen.recognition == Recognition::Novel) made_at[seen.template_id] = {pass, images_};
      if (seen.recognition == Recognition::Familiar) {
        const Template& place = made_at[seen.template_id];
        answers.push_back({{images_, place.image, seen.score, false, claimedPose(seen)},
                           place.pass == pass,
                           isTurned(seen)});
      }
      ++images_;
      frame_done();
    }
  }

  std::int64_t images() const { return images_; }

  std::vector<Answer> answers;
  std::vector<double> milliseconds;
  evaluation::Trajectory truth;  ///< of the images that have true poses

 private:
  bool next(Frame& frame) {
    if (images_ == options_.frames || cancellation_.requested()) return false;
    frame = Frame();
    const Status status = assembly_.source().next(frame);
    if (status.code() == StatusCode::EndOfStream) return false;
    engine::require(status, engine::FailureKind::Dataset);
    return true;
  }

  PlaceObservation observe(const Frame& frame) {
    const Motion motion = motionTo(frame);
    const bool wants_motion = assembly_.place().input() == PlaceInput::FrameAndMotion;
    PlaceObservation seen;
    const std::int64_t begin_ns = clock_.steadyNs();
    engine::require(assembly_.place().observe(frame, wants_motion ? &motion : nullptr, seen),
                    engine::FailureKind::Stage);
    milliseconds.push_back(1e-6 * static_cast<double>(clock_.steadyNs() - begin_ns));
    return seen;
  }

  /// The true motion where it is known, otherwise metres_per_image straight ahead.
  Motion motionTo(const Frame& frame) {
    Motion motion;
    motion.frame = frame.frame;
    motion.stamp_ns = frame.stamp_ns;
    const bool follows = !truth.empty() && truth.back().frame == images_ - 1;
    if (images_ > 0) {
      motion.state = TrackingState::Tracking;
      motion.T_previous_current.translation().z() = options_.metres_per_image;
      if (frame.has_truth && follows) {
        motion.T_previous_current =
            truth.back().T_world_camera.inverse() * frame.T_world_camera_truth;
      }
      motion.covariance = 1e-4 * Matrix6d::Identity();
      setPlanarVelocity(motion, 1e-9 * static_cast<double>(frame.stamp_ns - last_stamp_ns_));
    }
    if (frame.has_truth) truth.push_back({images_, frame.stamp_ns, frame.T_world_camera_truth});
    last_stamp_ns_ = frame.stamp_ns;
    return motion;
  }

  engine::Assembly& assembly_;
  const PlacesOptions& options_;
  const Cancellation& cancellation_;
  engine::SteadyClock clock_;
  std::int64_t images_ = 0;
  std::int64_t last_stamp_ns_ = 0;
};

/// Whether a parameter of the source has this value (as JSON), or the source has no such one.
bool isSourceAt(const engine::CheckedSystem& system, const std::string& name,
                const std::string& value) {
  const ParameterValues& source = system.values.at(system.config.stages.front().instance);
  const auto found = source.find(name);
  return found == source.end() || engine::valueJson(found->second).dump() == value;
}

[[noreturn]] void refuseBench(engine::FailureKind kind, const std::string& why) {
  throw engine::Failure({kind, why});
}

/// Pairs number the images of the recording: all must be shown, in their order.
void refuseSelection(const engine::CheckedSystem& system) {
  for (const auto& [name, whole] : {std::pair<const char*, std::string>("first", "0"),
                                    {"step", "1"},
                                    {"order", "\"forward\""}}) {
    if (isSourceAt(system, name, whole)) continue;
    refuseBench(engine::FailureKind::Configuration,
                fmt::format("--pairs numbers all images of the recording, and source.{} "
                            "selects some; leave it at {}",
                            name, whole));
  }
}

std::int64_t countFindable(const PlaceTruth& truth, const Pass& pass) {
  std::int64_t count = 0;
  for (std::int64_t i = 0; i < pass.images(); ++i) count += truth.isFindable(i);
  return count;
}

/// Claims about images without a true pose are neither right nor wrong.
void leaveOutUnknown(Pass& pass, engine::RunLog& log) {
  const std::int64_t unknown = pass.images() - std::ssize(pass.truth);
  if (unknown == 0) return;
  log.write(LogLevel::Warning, "source",
            fmt::format("{} of {} images have no true pose; what is claimed of them is not judged",
                        unknown, pass.images()));
  std::erase_if(pass.answers, [&](const Answer& answer) {
    return !poseOf(pass.truth, answer.claim.query) || !poseOf(pass.truth, answer.claim.place);
  });
}

/// Of one drive.
PlaceTruth truthOf(const Pass& pass, const engine::CheckedSystem& system,
                   const PlacesOptions& options, bool is_cancelled) {
  if (options.pairs.empty()) {
    if (!pass.truth.empty()) {
      return truthOfPoses(pass.truth, system.config.evaluation.loop_height, options.near);
    }
    refuseBench(engine::FailureKind::Configuration,
                "nothing says which images show the same place: the source has no true "
                "poses; give --pairs or --second");
  }
  PlaceTruth truth =
      engine::require(truthOfPairs(options.pairs, options.near), engine::FailureKind::Dataset);
  // With source.last and --frames the images may end before the pairs.
  const bool whole = options.frames < 0 && isSourceAt(system, "last", "-1");
  if (whole && !is_cancelled && truth.last_query >= pass.images()) {
    refuseBench(
        engine::FailureKind::Dataset,
        fmt::format("{}: names image {}, and the recording has {} images, from 0; are these the "
                    "pairs of this recording?",
                    options.pairs, truth.last_query, pass.images()));
  }
  if (countFindable(truth, pass) > 0) return truth;
  refuseBench(engine::FailureKind::Dataset,
              fmt::format("{}: has no pair of the {} images that were shown whose "
                          "images are more than {} apart (--near)",
                          options.pairs, pass.images(), options.near));
}

void judge(const Pass& pass, const PlaceTruth& truth, const PlacesOptions& options,
           PlacesBench& bench) {
  for (const auto& [claim, within_pass, turned] : pass.answers) {
    const bool counts =
        options.second.empty() ? claim.query - claim.place > options.near : !within_pass;
    if (!counts || (bench.opposite && turned)) continue;
    bench.claims.push_back(claim);
    bench.claims.back().right = truth.isSame(claim.query, claim.place);
  }
  bench.findable = countFindable(truth, pass);
  bench.curve = evaluation::precisionRecall(bench.claims, bench.findable);
  std::vector<double> times = pass.milliseconds;
  if (times.empty()) return;
  std::ranges::sort(times);
  bench.median_ms = times[times.size() / 2];
  bench.p99_ms = times[times.size() * 99 / 100];
}

void keepState(engine::Assembly& assembly, PlacesBench& bench) {
  if (assembly.place().instance().state() == nullptr) return;
  const Result<std::string> state = assembly.place().instance().save();
  if (state.isOk()) bench.state_bytes = static_cast<std::int64_t>(state.value().size());
}

}  // namespace

PlacesBench runPlacesBench(const engine::SystemOptions& system, const PlacesOptions& options,
                           engine::RunLog& log, const Cancellation& cancellation) {
  const engine::SteadyClock clock;
  PlacesBench bench;
  std::map<std::int64_t, Pass::Template> made_at;
  const auto assemble = [&](const engine::SystemOptions& of) {
    return engine::Assembly(engine::checkSystem(of, engine::Scope::SourceAndPlace), log, clock,
                            cancellation);
  };
  engine::Assembly first = assemble(system);
  if (!options.pairs.empty()) refuseSelection(first.system());
  bench.name = first.system().config.general.name;
  bench.plugin = first.place().instance().manifest().id;
  Pass pass(first, options, cancellation);
  pass.show(0, made_at);
  bench.images = pass.images();
  if (options.second.empty()) {
    const PlaceTruth truth = truthOf(pass, first.system(), options, cancellation.requested());
    if (options.pairs.empty()) {  // with true poses
      leaveOutUnknown(pass, log);
      std::vector<evaluation::PlaceClaim> turned;
      for (const Answer& answer : pass.answers) {
        if (answer.turned) turned.push_back(answer.claim);
      }
      bench.opposite = judgeOpposite(pass.truth, std::move(turned),
                                     first.system().config.evaluation.loop_height);
    }
    judge(pass, truth, options, bench);
    keepState(first, bench);
  } else {
    const std::string state =
        engine::require(first.place().instance().save(), engine::FailureKind::Configuration);
    engine::SystemOptions again = system;
    again.overrides.push_back("source.path=" + config::writeText(options.second));
    again.overrides.insert(again.overrides.end(), options.query_overrides.begin(),
                           options.query_overrides.end());
    engine::Assembly second = assemble(again);
    engine::require(second.place().instance().load(state), engine::FailureKind::Configuration,
                    "place");
    second.place().resetChecks(static_cast<std::int64_t>(made_at.size()));
    Pass queries(second, options, cancellation);
    queries.show(1, made_at);
    if (queries.images() != bench.images && !cancellation.requested()) {
      log.write(LogLevel::Warning, "source",
                fmt::format("the second pass has {} images, and the first has {}: are some "
                            "missing? Image N of both must show the same place",
                            queries.images(), bench.images));
    }
    bench.images += queries.images();
    judge(queries, truthByNumber(pass.images(), options.tolerance), options, bench);
    keepState(second, bench);
  }
  bench.templates = static_cast<std::int64_t>(made_at.size());
  bench.interrupted = cancellation.requested();
  return bench;
}

namespace {

using Json = Table::Json;

Json claimsJson(const std::vector<evaluation::PlaceClaim>& claims) {
  Json list = Json::array();
  for (const evaluation::PlaceClaim& c : claims) {
    list.push_back(
        {{"query", c.query}, {"place", c.place}, {"score", c.score}, {"right", c.right}});
    if (c.error_m > 0) list.back()["error_m"] = c.error_m;
  }
  return list;
}

void addOpposite(const OppositePlaces& opposite, Table& table) {
  table.about["opposite"] = {{"findable", opposite.findable},
                             {"found", opposite.found},
                             {"median_error_m", opposite.medianError()},
                             {"claims", claimsJson(opposite.claims)}};
  if (opposite.findable == 0 && opposite.claims.empty()) return;
  table.notes.push_back(
      fmt::format("opposite direction: {} claims, {} right, with a median error of {:.2f} m",
                  opposite.claims.size(), opposite.right(), opposite.medianError()));
  if (opposite.findable == 0) return;
  const double share = static_cast<double>(opposite.found) / static_cast<double>(opposite.findable);
  table.notes.push_back(
      fmt::format("{} images pass a known place, {:.3f} of them at most 5 m after a right claim",
                  opposite.findable, share));
}

}  // namespace

Table tableOf(const PlacesBench& bench) {
  Table table{{"score", "claims", "precision", "recall"}, {}};
  table.keys = table.heading;
  table.title = fmt::format("{}: place recogniser '{}', {} images, {} templates", bench.name,
                            bench.plugin, bench.images, bench.templates);
  constexpr std::size_t kMost = 12;  // rows for readers, evenly spaced, the last one included
  const std::size_t size = bench.curve.size(), count = std::min(kMost, size);
  for (std::size_t i = 1; i <= count; ++i) {
    const evaluation::PrecisionRecall& point = bench.curve[i * size / count - 1];
    table.rows.push_back({fmt::format("{:.4g}", point.score), std::to_string(point.claims),
                          fmt::format("{:.3f}", point.precision),
                          fmt::format("{:.3f}", point.recall)});
  }
  for (const evaluation::PrecisionRecall& point : bench.curve) {
    table.values.push_back({point.score, point.claims, point.precision, point.recall});
  }
  table.about = {{"name", bench.name},
                 {"plugin", bench.plugin},
                 {"images", bench.images},
                 {"templates", bench.templates},
                 {"findable", bench.findable},
                 {"median_ms", bench.median_ms},
                 {"p99_ms", bench.p99_ms},
                 {"state_bytes", bench.state_bytes},
                 {"interrupted", bench.interrupted}};
  table.notes.push_back(fmt::format("{} images have a place to be found", bench.findable));
  for (const int percent : {100, 99, 90}) {
    const double recall = evaluation::recallAt(bench.curve, percent / 100.0);
    table.about[fmt::format("recall_at_{}", percent)] = recall;
    table.notes.push_back(fmt::format("recall at {} % precision: {:.3f}", percent, recall));
  }
  table.about["claims"] = claimsJson(bench.claims);
  if (bench.opposite) addOpposite(*bench.opposite, table);
  table.notes.push_back(fmt::format("time of a call: {:.2f} ms median, {:.2f} ms at 99 %",
                                    bench.median_ms, bench.p99_ms));
  if (bench.state_bytes > 0 && bench.templates > 0) {
    table.notes.push_back(
        fmt::format("saved state: {} bytes, {:.0f} a template", bench.state_bytes,
                    static_cast<double>(bench.state_bytes) / static_cast<double>(bench.templates)));
  }
  return table;
}

}  // namespace tolman::experiment
