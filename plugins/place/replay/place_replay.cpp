// SPDX-License-Identifier: BSD-3-Clause
#include "place_replay.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace tolman::place_replay {
namespace {

constexpr std::string_view kMagic = "TLMPLRPL";
constexpr std::uint64_t kStateVersion = 4;
constexpr std::int64_t kNothing = -1;
constexpr float kUnknownDrive = -1;
using RandomWords = std::array<std::uint64_t, sizeof(RandomStream) / sizeof(std::uint64_t)>;

/// The sensor array of this name; null if the frame has none.
const NamedArray* sensor(const Frame& frame, std::string_view name) {
  const auto found = std::ranges::find(frame.sensors, name, &NamedArray::name);
  return found == frame.sensors.end() ? nullptr : &*found;
}

/// Within the bounds of saved indices and counters, which are subtracted and incremented later.
bool isIndex(std::int64_t index) {
  constexpr std::int64_t kMax = std::int64_t{1} << 62U;
  return index > -kMax && index < kMax;
}

/// Bound of the numbers of a saved pose, m and rad; false for NaN.
bool isNear(double number) { return std::abs(number) <= 1e9; }

}  // namespace

Status PlaceReplay::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  seed_ = context.seed;
  log_ = &context.log;
  localises_ = context.localise;
  if (!parameters_.record.empty()) {
    if (localises_) {
      return Status::invalidParameter(
          "recorded answers name the templates of their own run; leave out record to localise");
    }
    if (parameters_.kept < 1 || parameters_.invented > 0) {
      return Status::invalidParameter(
          "kept and invented need the candidates of the source; leave them out with record");
    }
    if (Status opened = reader_.open(parameters_.record); !opened.isOk()) return opened;
  }
  return reset();
}

Status PlaceReplay::reset() {
  random_ = RandomStream(seed_);
  views_.clear();
  templates_ = 0;
  drive_.reset();
  last_compared_.reset();
  pending_.reset();
  run_end_ = -1;
  run_offset_ = 0;
  warned_of_lost_ = false;
  return Status::ok();
}

void PlaceReplay::removeViewsOfOtherDrive(const Frame& frame) {
  const NamedArray* drive = sensor(frame, "motion.drive");
  if (drive == nullptr || drive->values.empty()) return;
  const float here = drive->values[0];
  if (drive_ && *drive_ != here) {
    log_->warning("the " + std::to_string(views_.size()) +
                  " saved views belong to another drive, on which frame numbers mean other places; "
                  "they are removed");
    views_.clear();
    last_compared_.reset();
    pending_.reset();
    warned_of_lost_ = true;  // by the line above
  }
  drive_ = here;
}

void PlaceReplay::makeTemplate(std::int64_t source_index, const PlanarPose& in_template,
                               PlaceObservation& observation) {
  // A frame that is played again (pingpong) keeps its first template.
  views_.try_emplace(source_index, ReplayedView{templates_, in_template});
  observation.recognition = Recognition::Novel;
  observation.template_id = templates_++;
}

void PlaceReplay::reportMatch(const ReplayedView& view, const PlanarPose& here_in_earlier,
                              PlaceObservation& observation) const {
  const PlanarPose here = compose(view.in_template, here_in_earlier);
  observation.recognition = Recognition::Familiar;
  observation.template_id = view.template_id;
  observation.relative_yaw = here.theta;
  if (!parameters_.relative_pose) return;
  observation.has_relative_pose = true;
  observation.T_template_current = fromPlanar(here);
  const double p = parameters_.sigma_position * parameters_.sigma_position;
  const double h = parameters_.sigma_heading * parameters_.sigma_heading;
  observation.covariance.diagonal() << p, p, p, h, h, h;
}

/// A frame that is known to be compared, or every `view_step` frames since the last compared one.
bool PlaceReplay::isCompared(const Frame& frame) {
  const NamedArray* looked = sensor(frame, "place.looked");
  const NamedArray* alike = sensor(frame, "place.candidate");
  const bool known = (looked != nullptr && !looked->values.empty() && looked->values[0] > 0) ||
                     (alike != nullptr && !alike->values.empty());
  const bool due =
      !last_compared_ || std::abs(frame.source_index - *last_compared_) >= parameters_.view_step;
  if (known || due) last_compared_ = frame.source_index;
  return known || due;
}

/// Reports the first candidate whose view is known.
bool PlaceReplay::recognise(const Frame& frame, PlaceObservation& observation) {
  const NamedArray* alike = sensor(frame, "place.candidate");
  if (alike == nullptr) return false;
  for (std::size_t i = 0; i + 4 <= alike->values.size(); i += 4) {
    const auto number = [&](std::size_t k) { return static_cast<double>(alike->values[i + k]); };
    const auto view = views_.find(std::llround(number(0)));
    if (view == views_.end()) continue;
    if (parameters_.kept < 1 && random_.uniform() >= parameters_.kept) continue;
    // The candidate has the pose of the earlier frame in this one; the observation has the inverse.
    reportMatch(view->second, between({number(1), number(2), number(3)}, {}), observation);
    return true;
  }
  return false;
}

void PlaceReplay::warnOfLost(const Frame& frame) {
  const NamedArray* alike = sensor(frame, "place.candidate");
  const auto is_known = [&](float index) { return views_.contains(std::llround(index)); };
  if (warned_of_lost_ || alike == nullptr || alike->values.size() < 4) return;
  for (std::size_t i = 0; i + 4 <= alike->values.size(); i += 4) {
    if (is_known(alike->values[i])) return;  // `kept` leaves it out
  }
  warned_of_lost_ = true;
  log_->warning("image " + std::to_string(frame.source_index) + " resembles image " +
                std::to_string(std::llround(alike->values[0])) +
                ", of which this run has no view (left out by the source's first or step, or "
                "dropped): such candidates are lost, this is the first");
}

std::optional<PlaceReplay::ReplayedView> PlaceReplay::lookAlike(std::int64_t source_index) {
  if (source_index < run_end_) {
    const auto next = views_.find(source_index + run_offset_);
    if (next != views_.end()) return next->second;
  }
  if (random_.uniform() >= parameters_.invented) return std::nullopt;
  const auto young = views_.lower_bound(source_index - parameters_.invented_age);
  const auto old = std::distance(views_.begin(), young);
  if (old == 0) return std::nullopt;
  const auto pick = random_.below(static_cast<std::uint64_t>(old));
  const auto& [index, view] = *std::next(views_.begin(), static_cast<std::ptrdiff_t>(pick));
  if (parameters_.invented_run > 1 && source_index >= run_end_) {
    const auto more = random_.below(static_cast<std::uint64_t>(parameters_.invented_run));
    run_end_ = source_index + static_cast<std::int64_t>(more) * parameters_.view_step + 1;
    run_offset_ = index - source_index;
  }
  return view;
}

bool PlaceReplay::reportFalseMatch(const Frame& frame, PlaceObservation& observation) {
  if (!(parameters_.invented > 0)) return false;
  const std::optional<ReplayedView> view = lookAlike(frame.source_index);
  if (view) reportMatch(*view, {}, observation);
  return view.has_value();
}

Status PlaceReplay::observe(const Frame& frame, const Motion* motion,
                            PlaceObservation& observation) {
  if (!parameters_.record.empty()) return reader_.read(frame, observation);
  observation.frame = frame.frame;
  observation.stamp_ns = frame.stamp_ns;
  removeViewsOfOtherDrive(frame);
  // After a restart at an unknown pose the motion from the pending view is not known.
  if (motion && motion->state == TrackingState::Initialising) pending_.reset();
  const bool look = isCompared(frame);
  if (recognise(frame, observation) || reportFalseMatch(frame, observation)) {
    pending_ = frame.source_index;
    return Status::ok();
  }
  if (localises_) return Status::ok();
  warnOfLost(frame);
  if (look) {
    pending_.reset();
    makeTemplate(frame.source_index, {}, observation);
    return Status::ok();
  }
  if (pending_ && motion) {
    // The pending view is that of the previous frame, one motion before this one.
    makeTemplate(*pending_, between(toPlanar(motion->T_previous_current), {}), observation);
    pending_.reset();
  }
  return Status::ok();
}

Status PlaceReplay::save(std::ostream& stream) const {
  StateWriter writer;
  for (const std::uint64_t word : std::bit_cast<RandomWords>(random_)) writer.put(word);
  writer.put(templates_);
  writer.put(drive_.value_or(kUnknownDrive));
  writer.put(last_compared_.value_or(kNothing));
  writer.put(pending_.value_or(kNothing));
  writer.put(run_end_);
  writer.put(run_offset_);
  writer.put(static_cast<std::int64_t>(views_.size()));
  for (const auto& [source_index, view] : views_) {
    writer.put(source_index);
    writer.put(view.template_id);
    for (const double number : {view.in_template.x, view.in_template.y, view.in_template.theta}) {
      writer.put(number);
    }
  }
  return writer.write(stream, kMagic, kStateVersion);
}

Status PlaceReplay::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  const Status status = read(opened.value());
  if (!status.isOk()) (void)reset();
  return status;
}

Status PlaceReplay::read(StateReader& reader) {
  RandomWords words{};
  for (std::uint64_t& word : words) word = reader.get<std::uint64_t>();
  random_ = std::bit_cast<RandomStream>(words);
  templates_ = reader.get<std::int64_t>();
  if (const auto drive = reader.get<float>(); drive != kUnknownDrive) drive_ = drive;
  const auto last_look = reader.get<std::int64_t>();
  if (last_look != kNothing) last_compared_ = last_look;
  const auto owed = reader.get<std::int64_t>();
  if (owed != kNothing) pending_ = owed;
  run_end_ = reader.get<std::int64_t>();
  run_offset_ = reader.get<std::int64_t>();
  bool sound =
      std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; }) && templates_ >= 0 &&
      std::ranges::all_of(std::array{templates_, last_look, owed, run_end_, run_offset_}, isIndex);
  const auto count = reader.get<std::int64_t>();
  for (std::int64_t i = 0; i < count && reader.remaining() > 0; ++i) {
    const auto source_index = reader.get<std::int64_t>();
    ReplayedView& view = views_[source_index];
    view.template_id = reader.get<std::int64_t>();
    PlanarPose& pose = view.in_template;
    for (double* number : {&pose.x, &pose.y, &pose.theta}) *number = reader.get<double>();
    sound = sound && isIndex(source_index) && view.template_id >= 0 &&
            view.template_id < templates_ &&
            std::ranges::all_of(std::array{pose.x, pose.y, pose.theta}, isNear);
  }
  sound = sound && static_cast<std::int64_t>(views_.size()) == count;
  if (sound && reader.complete()) return Status::ok();
  return Status::invalidInput("the saved views are damaged: numbers that cannot be");
}

}  // namespace tolman::place_replay
