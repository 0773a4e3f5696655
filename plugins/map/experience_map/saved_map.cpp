// SPDX-License-Identifier: BSD-3-Clause
#include "saved_map.hpp"

#include <algorithm>
#include <array>
#include <tolman/state_stream.hpp>
#include <utility>

namespace tolman::experience_map {
namespace {

constexpr std::string_view kMagic = "TLMEXMAP";
constexpr std::uint64_t kStateVersion = 4;
/// Bound of counters and stamps: counters are incremented later, stamps subtracted.
constexpr std::int64_t kMax = std::int64_t{1} << 62U;

void put(StateWriter& writer, const UncertainPose& pose) {
  writer.putAll(std::span<const double>(pose.T.data(), 16));
  writer.putAll(std::span<const double>(pose.covariance.data(), 36));
}

UncertainPose getPose(StateReader& reader) {
  UncertainPose pose;
  reader.getAll(std::span<double>(pose.T.data(), 16));
  reader.getAll(std::span<double>(pose.covariance.data(), 36));
  return pose;
}

template <class Archive, class Calibration>
void numbers(Archive archive, Calibration& calibration) {
  for (int k = 0; k < kSpatialErrors; ++k) archive(calibration.errors[k]);
  for (int k = 0; k < kSpatialErrors; ++k) archive(calibration.sigmas[k]);
  archive(calibration.turning);
  archive(calibration.turning_sigma);
  archive(calibration.noise_distance);
  archive(calibration.noise_turns);
}

template <class Archive, class Assumed>
void factors(Archive archive, Assumed& assumed) {
  for (auto factor :
       {&Assumptions::odometry_distance, &Assumptions::odometry_turns, &Assumptions::loop_distance,
        &Assumptions::loop_turns, &Assumptions::errors}) {
    archive(assumed.*factor);
  }
}

struct SavedFrame {
  ReckonedFrame frame;
  UncertainPose motion;
};

void put(StateWriter& writer, const ReckonedFrame& frame, const UncertainPose& motion) {
  writer.put(frame.frame);
  writer.put(frame.stamp_ns);
  writer.put(frame.anchor);
  writer.put(std::int64_t{frame.initialising});
  writer.put(std::int64_t{frame.gap});
  put(writer, motion);
}

SavedFrame getFrame(StateReader& reader) {
  SavedFrame saved;
  ReckonedFrame& frame = saved.frame;
  frame.frame = reader.get<std::int64_t>();
  frame.stamp_ns = reader.get<std::int64_t>();
  frame.anchor = reader.get<std::int64_t>();
  frame.initialising = reader.get<std::int64_t>() != 0;
  frame.gap = reader.get<std::int64_t>() != 0;
  saved.motion = getPose(reader);
  return saved;
}

void put(StateWriter& writer, const Anchor& anchor) {
  writer.put(static_cast<std::int64_t>(anchor.slot));
  writer.put(anchor.experience);
  writer.put(anchor.template_id);
  for (const bool flag : {anchor.gap, anchor.visit, anchor.assumed, anchor.rejected}) {
    writer.put(std::int64_t{flag});
  }
  writer.put(anchor.odometry_weight);
  writer.put(anchor.offset_weight);
  writer.putAll(std::span<const double>(anchor.correction.data(), 16));
  put(writer, anchor.offset);
}

Anchor getAnchor(StateReader& reader) {
  Anchor anchor;
  anchor.slot = static_cast<std::size_t>(reader.get<std::int64_t>());
  anchor.experience = reader.get<std::int64_t>();
  anchor.template_id = reader.get<std::int64_t>();
  for (bool* flag : {&anchor.gap, &anchor.visit, &anchor.assumed, &anchor.rejected}) {
    *flag = reader.get<std::int64_t>() != 0;
  }
  anchor.odometry_weight = reader.get<double>();
  anchor.offset_weight = reader.get<double>();
  reader.getAll(std::span<double>(anchor.correction.data(), 16));
  anchor.offset = getPose(reader);
  return anchor;
}

/// Reads a list after its size. Stops at the end of the bytes, whatever the size says.
template <class T>
GrowingList<T> getList(StateReader& reader, T (*get)(StateReader&)) {
  const auto count = reader.get<std::int64_t>();
  GrowingList<T> list;
  for (std::int64_t i = 0; i < count && reader.remaining() > 0; ++i) list.push_back(get(reader));
  return list;
}

bool areSound(const GrowingList<SavedFrame>& frames, std::size_t anchors) {
  for (std::size_t slot = 0; slot < frames.size(); ++slot) {
    const ReckonedFrame& frame = frames[slot].frame;
    const bool later = slot == 0 || frame.frame > frames[slot - 1].frame.frame;
    if (!later || frame.frame < 0 || frame.frame >= kMax || frame.stamp_ns >= kMax ||
        frame.stamp_ns <= -kMax || frame.anchor < 0 ||
        frame.anchor >= static_cast<std::int64_t>(anchors)) {
      return false;
    }
  }
  return frames.empty() == (anchors == 0);
}

/// Checks that anchors are in the order of their frames, that experiences are numbered in the order
/// of creation, and that visits follow the creation of their experience.
bool areSound(const GrowingList<Anchor>& anchors, const GrowingList<SavedFrame>& frames) {
  std::int64_t made = 0;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Anchor& anchor = anchors[i];
    const bool in_order =
        i == 0 ? anchor.slot == 0 && !anchor.visit : anchor.slot >= anchors[i - 1].slot;
    const bool known = anchor.visit ? anchor.experience >= 0 && anchor.experience < made
                                    : anchor.experience == -1 || anchor.experience == made;
    if (!in_order || !known || anchor.slot >= frames.size()) return false;
    if (!anchor.visit && anchor.experience >= 0) ++made;
  }
  return true;
}

}  // namespace

Status saveMap(const DeadReckoning& motions, const ExperienceChain& chain,
               const MapCounters& counters, std::ostream& stream) {
  StateWriter writer;
  writer.put(counters.version);
  writer.put(static_cast<std::int64_t>(counters.next_correction));
  writer.put(static_cast<std::int64_t>(motions.size()));
  for (std::size_t slot = 0; slot < motions.size(); ++slot) {
    put(writer, motions[slot], motions.motionTo(slot));
  }
  writer.put(static_cast<std::int64_t>(chain.anchors().size()));
  for (const Anchor& anchor : chain.anchors()) put(writer, anchor);
  writer.put(chain.links());
  writer.put(chain.loops());
  writer.put(std::int64_t{chain.pending()});
  writer.put(std::int64_t{motions.isMetric()});
  numbers([&](double number) { writer.put(number); }, chain.calibration());
  factors([&](double number) { writer.put(number); }, chain.assumptions());
  writer.put(static_cast<std::int64_t>(chain.loopsWhenEstimated()));
  return writer.write(stream, kMagic, kStateVersion);
}

Status loadMap(std::istream& stream, DeadReckoning& motions, ExperienceChain& chain,
               MapCounters& counters) {
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  StateReader& reader = opened.value();
  const auto version = reader.get<std::int64_t>();
  const auto next_correction = reader.get<std::int64_t>();
  const GrowingList<SavedFrame> frames = getList(reader, &getFrame);
  ExperienceChain::State state;
  state.anchors = getList(reader, &getAnchor);
  state.links = reader.get<std::int64_t>();
  state.loops = reader.get<std::int64_t>();
  state.pending = reader.get<std::int64_t>() != 0;
  const bool is_metric = reader.get<std::int64_t>() != 0;
  numbers([&](double& number) { number = reader.get<double>(); }, state.calibration);
  factors([&](double& number) { number = reader.get<double>(); }, state.assumptions);
  state.loops_when_estimated = static_cast<std::size_t>(reader.get<std::int64_t>());
  if (!reader.complete()) return Status::invalidInput("the saved map is damaged: wrong length");
  const bool counted =
      std::ranges::all_of(std::array{version, next_correction, state.links, state.loops},
                          [](std::int64_t number) { return number >= 0 && number < kMax; });
  if (!counted || !areSound(frames, state.anchors.size()) || !areSound(state.anchors, frames)) {
    return Status::invalidInput("the saved map is damaged: a number is out of range");
  }
  for (const SavedFrame& saved : frames) motions.restore(saved.frame, saved.motion);
  motions.setMetric(is_metric);
  chain.restore(motions, std::move(state));
  counters = {version, static_cast<std::size_t>(next_correction)};
  return Status::ok();
}

}  // namespace tolman::experience_map
