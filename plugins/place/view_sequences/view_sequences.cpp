// SPDX-License-Identifier: BSD-3-Clause
#include "view_sequences.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "path_cost.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {
namespace {

constexpr std::string_view kMagic = "TLMVSEQS";
// Least probability of a place that is tried with landmarks; chosen on the town along KITTI 06, 07.
constexpr double kTried = 0.01;

constexpr const char* kVersions = " (version 4: saved with `backwards`, 3: without)";
constexpr std::uint64_t versionOfState(bool backwards) { return backwards ? 4 : 3; }

EdgeValues levelsOf(const PackedView& view) {
  std::array<std::int16_t, kValues> levels;
  unpack(view, levels);
  EdgeValues values;
  for (std::size_t i = 0; i < kValues; ++i) values[i] = levels[i];
  return values;
}

/// Strength of the edges of each cell over all directions, 0 to 1; rows x columns.
std::vector<float> pictureOf(const PackedView& view) {
  const EdgeValues values = levelsOf(view);
  std::vector<float> picture;
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) {
      float sum = 0;
      for (int k = 0; k < kDirections; ++k) {
        sum += values[static_cast<std::size_t>((c * kRows + r) * kDirections + k)];
      }
      picture.push_back(sum / (15 * kDirections));
    }
  }
  return picture;
}

}  // namespace

Status ViewSequences::configure(const Context& context) {
  Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  if (context.rig.width == 0) {
    context.log.warning("the source has no images, so no place will be recognised");
  }
  parameters_ = std::move(bound).value();
  rig_ = context.rig;
  localises_ = context.localise;
  if (Status status = reset(); !status.isOk()) return status;
  if (parameters_.landmarks > 0 && !verifier_->canMeasure()) {
    context.log.warning(
        "landmarks need a calibrated stereo pair; places are recognised by appearance alone: set "
        "landmarks to 0");
  }
  if (parameters_.backwards && !backwards_->canMeasure()) {
    context.log.warning(
        "streets driven the other way need a calibrated stereo pair and are not recognised: set "
        "backwards to false");
  }
  return Status::ok();
}

Status ViewSequences::reset() {
  const Parameters& p = parameters_;
  SearchSettings settings;
  settings.exhaustive = p.exhaustive;
  settings.recent = p.recent;
  settings.cost.memory = p.memory;
  steps_ = std::make_unique<PathSteps>(p.spacing, p.recent);
  search_ = std::make_unique<PlaceSearch>(settings);
  verifier_ = std::make_unique<PlaceVerifier>(
      rig_,
      VerifierSettings{p.landmarks, landmarks::leastAgreeing(p.landmarks), p.landmark_spacing});
  backwards_ = std::make_unique<BackwardPlaces>(rig_, p.backwards, settings);
  mean_ = MeanView();
  current_ = PackedView{};
  at_ = -1;
  at_is_new_ = false;
  since_measured_ = kNever;
  since_backwards_ = kNever;
  return Status::ok();
}

Status ViewSequences::observe(const Frame& frame, const Motion* motion,
                              PlaceObservation& observation) {
  observation.frame = frame.frame;
  observation.stamp_ns = frame.stamp_ns;
  if (motion == nullptr) return Status::invalidInput("view_sequences needs the motion");
  const std::optional<PathStep> step = steps_->move(*motion);
  backwards_->move(*motion);
  if (!step) return Status::ok();
  EdgeValues edges;
  if (frame.left.empty() || !edgeGrid(frame.left, edges)) {
    steps_->postpone(*step);
    return Status::ok();
  }
  return processStep(*step, frame, packed(edges), observation);
}

Status ViewSequences::processStep(const PathStep& step, const Frame& frame, const PackedView& view,
                                  PlaceObservation& observation) {
  if (step.begins_pass) {
    mean_.beginPass();
    search_->beginPass();
    at_ = -1;
    since_measured_ = kNever;
  }
  current_ = view;
  const EdgeValues levels = levelsOf(view);
  mean_.add(levels);
  const ViewQuery query(levels, mean_.mean());
  search_->step(query, step.path, step.advance);
  verifier_->beginFrame(frame);
  backwards_->step(step, frame);
  since_measured_ = std::min(since_measured_ + 1, kNever);
  since_backwards_ = std::min(since_backwards_ + 1, kNever);
  return answer(step, query, frame.left.width(), observation);
}

Status ViewSequences::answer(const PathStep& step, const ViewQuery& query, int image_width,
                             PlaceObservation& observation) {
  // For landmark_spacing steps after a measured pose, and without a new one for kSilentSteps steps,
  // a likely place is neither reported nor stored as new: without a pose it would be known only to
  // a few metres.
  constexpr std::int64_t kSilentSteps = 20;  // steps; chosen, not tuned
  const std::vector<PlaceCandidate> found =
      search_->candidates(verifier_->canMeasure() ? PlaceSearch::kMaxPlaces : 1);
  const double probability = found.empty() ? 0 : found.front().probability;
  observation.score = 1 - probability;
  const bool likely = probability >= kTried;
  agreement_ = {};
  explain(found, observation);
  if (likely && since_measured_ < parameters_.landmark_spacing) return Status::ok();
  const auto place = verified(found);
  if (!place.isOk()) return place.status();
  explain(found, observation);
  if (place.value()) {
    recognise(*place.value(), query, image_width, observation);
  } else if (probability >= parameters_.probability) {
    if (since_measured_ > kSilentSteps)
      recognise({found.front().view, {}}, query, image_width, observation);
  } else if (!recogniseBackwards(observation) && !localises_) {
    return store(step, observation);
  }
  return Status::ok();
}

void ViewSequences::explain(const std::vector<PlaceCandidate>& found,
                            PlaceObservation& observation) const {
  observation.candidates.clear();
  if (found.empty()) return;
  Candidate& best = observation.candidates.emplace_back();
  best.template_id = found.front().view;
  best.score = 1 - found.front().probability;
  best.limit = 1 - parameters_.probability;
  best.agreeing = agreement_.agreeing;
  best.compared = agreement_.compared;
  best.needed = agreement_.needed;
  if (since_measured_ > 0 && since_measured_ < kNever && agreement_.compared < 0 &&
      found.front().probability >= kTried) {
    best.reason = "landmarks were measured " + std::to_string(since_measured_) + " steps ago";
  }
}

/// The place whose landmarks agree on a pose near it: by their corners, and if these give no pose,
/// by the edges around the landmarks.
Result<std::optional<ViewSequences::VerifiedView>> ViewSequences::verified(
    const std::vector<PlaceCandidate>& candidates) {
  auto place = verifiedBy(&PlaceVerifier::locate, candidates);
  if (place.isOk() && !place.value()) {
    place = verifiedBy(&PlaceVerifier::locateByEdges, candidates);
  }
  if (place.isOk() && place.value()) since_measured_ = 0;
  return place;
}

/// The most probable place with a measured pose, if its probability is at least kSure; otherwise
/// the one with the most inliers, because similar house fronts repeat along a street. Poses farther
/// away than kFarthestPose are not used: they are of views further along the same street, with
/// errors of metres.
Result<std::optional<ViewSequences::VerifiedView>> ViewSequences::verifiedBy(
    Locate locate, const std::vector<PlaceCandidate>& candidates) {
  constexpr double kSure = 0.9;  // chosen, not tuned
  std::optional<VerifiedView> best;
  for (const PlaceCandidate& candidate : candidates) {
    if (candidate.probability < kTried) break;
    const auto view = verifier_->viewNear(candidate.view);
    if (!view) continue;
    auto pose = ((*verifier_).*locate)(*view);
    if (!pose.isOk()) return pose.status();
    if (agreement_.compared < 0) agreement_ = verifier_->agreement();
    if (!pose.value()) continue;
    const landmarks::MeasuredPose& measured = *pose.value();
    if (measured.T_template_current.translation().norm() > kFarthestPose) continue;
    if (best && measured.inliers <= best->pose->inliers) continue;
    best = VerifiedView{*view, std::move(pose).value()};
    if (candidate.probability >= kSure) break;
  }
  return best ? measuredNearer(locate, *best) : best;
}

/// The same place, measured from the view with landmarks that is nearest to the measured pose:
/// poses are more exact the nearer they are.
Result<std::optional<ViewSequences::VerifiedView>> ViewSequences::measuredNearer(
    Locate locate, const VerifiedView& place) {
  const auto lengthOf = [](const landmarks::MeasuredPose& pose) {
    return pose.T_template_current.translation().norm();
  };
  const double ahead = place.pose->T_template_current.translation().z();
  const std::int64_t views = std::llround(ahead / parameters_.spacing);
  const auto view = verifier_->viewNear(place.view + views);
  if (!view || *view == place.view) return std::optional(place);
  auto pose = ((*verifier_).*locate)(*view);
  if (!pose.isOk()) return pose.status();
  const bool nearer = pose.value() && lengthOf(*pose.value()) < lengthOf(*place.pose);
  return std::optional(nearer ? VerifiedView{*view, std::move(pose).value()} : place);
}

/// Recognises a street that is driven in the opposite direction, once in `landmark_spacing` steps.
/// In between its views are stored, so that it becomes known in both directions.
bool ViewSequences::recogniseBackwards(PlaceObservation& observation) {
  const auto place = backwards_->find(parameters_.probability_backwards);
  if (!place || since_backwards_ < parameters_.landmark_spacing) return false;
  since_backwards_ = 0;
  observation.score = 1 - place->probability;
  observation.recognition = Recognition::Familiar;
  observation.template_id = place->view;
  observation.has_relative_pose = true;
  observation.T_template_current = place->T_template_current;
  observation.covariance = place->covariance;
  observation.relative_yaw = toPlanar(place->T_template_current).theta;
  return true;
}

Status ViewSequences::store(const PathStep& step, PlaceObservation& observation) {
  observation.recognition = Recognition::Novel;
  observation.template_id = search_->bank().size();
  search_->add(current_, step.path, at_);
  backwards_->add(step.path, at_);
  at_ = observation.template_id;
  at_is_new_ = true;
  return verifier_->store(at_);
}

void ViewSequences::recognise(const VerifiedView& place, const ViewQuery& query, int image_width,
                              PlaceObservation& observation) {
  if (at_is_new_ && at_ >= 0) {
    search_->join(at_, place.view);
    backwards_->join(at_, place.view);
  }
  at_ = place.view;
  at_is_new_ = false;
  observation.recognition = Recognition::Familiar;
  observation.template_id = place.view;
  observation.has_relative_pose = place.pose.has_value();
  if (place.pose) {
    observation.T_template_current = place.pose->T_template_current;
    observation.covariance = place.pose->covariance;
    observation.relative_yaw = toPlanar(observation.T_template_current).theta;
  } else {
    const MeasuredShift shift = shiftOf(query, search_->bank(), place.view);
    observation.relative_yaw = yawOf(shift.moved_left, image_width);
  }
}

/// Yaw (rad, positive to the left) of the camera whose scene has moved by `moved_left_cells`: when
/// the camera turns left, the scene moves to the right.
double ViewSequences::yawOf(double moved_left_cells, int image_width) const {
  const double cell_px = static_cast<double>(image_width) / kColumns;
  const double half = 0.5 * parameters_.field_of_view * std::numbers::pi / 180;
  const double focal = rig_.calibrated ? rig_.pinhole.fx : 0.5 * image_width / std::tan(half);
  return -std::atan(moved_left_cells * cell_px / focal);
}

void ViewSequences::arrays(std::vector<NamedArray>& arrays) const {
  const std::vector<int> shape = {kRows, kColumns};
  PackedView stored{};
  if (at_ >= 0) std::ranges::copy(search_->bank().view(at_), stored.begin());
  arrays.push_back({"view.current", shape, pictureOf(current_)});
  arrays.push_back({"view.template", shape, pictureOf(stored)});
}

Status ViewSequences::describe(std::vector<ArrayInfo>& arrays) const {
  for (const char* name : {"view.current", "view.template"}) {
    ArrayInfo view;
    view.name = name;
    view.doc = std::string(name) == "view.current" ? "edges of the current view"
                                                   : "edges of the view of the last answer";
    view.axes.resize(2);
    view.axes[0].name = "row";
    view.axes[1].name = "column";
    arrays.push_back(std::move(view));
  }
  return Status::ok();
}

/// The parameters that the stored state depends on.
std::vector<double> ViewSequences::storedParameters() const {
  return {parameters_.spacing, parameters_.memory, static_cast<double>(parameters_.landmarks)};
}

Status ViewSequences::save(std::ostream& stream) const {
  StateWriter writer;
  writer.putAll<double>(storedParameters());
  steps_->save(writer);
  mean_.save(writer);
  search_->save(writer);
  if (Status status = verifier_->save(writer); !status.isOk()) return status;
  writer.put(since_measured_);
  writer.putAll<std::uint8_t>(current_);
  writer.put(at_);
  writer.put(static_cast<std::uint8_t>(at_is_new_));
  if (parameters_.backwards) {
    backwards_->save(writer);
    writer.put(since_backwards_);
  }
  return writer.write(stream, kMagic, versionOfState(parameters_.backwards));
}

Status ViewSequences::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  Result<StateReader> opened =
      StateReader::open(stream, kMagic, versionOfState(parameters_.backwards));
  if (!opened.isOk()) {
    const std::string message = opened.status().message();
    const bool is_version = message.find("version") != std::string::npos;
    return Status::invalidInput(message + (is_version ? kVersions : ""));
  }
  StateReader& reader = opened.value();
  std::vector<double> saved(storedParameters().size());
  reader.getAll<double>(saved);
  if (saved != storedParameters()) {
    return Status::invalidInput(
        "the saved views were made with another spacing, memory or number of landmarks");
  }
  bool sound = steps_->load(reader) && mean_.load(reader) && search_->load(reader);
  if (sound) {
    const Status status = verifier_->load(reader, search_->bank().size());
    if (!status.isOk()) {
      static_cast<void>(reset());
      return status;
    }
  }
  since_measured_ = reader.get<std::int64_t>();
  reader.getAll<std::uint8_t>(current_);
  at_ = reader.get<std::int64_t>();
  at_is_new_ = reader.get<std::uint8_t>() != 0;
  if (parameters_.backwards && sound) {
    sound = backwards_->load(reader, search_->bank().size());
    since_backwards_ = reader.get<std::int64_t>();
  }
  if (!sound || !reader.complete() || at_ < -1 || at_ >= search_->bank().size() ||
      since_measured_ < 0 || since_measured_ > kNever || since_backwards_ < 0 ||
      since_backwards_ > kNever) {
    static_cast<void>(reset());
    return Status::invalidInput("the saved state is damaged");
  }
  return Status::ok();
}

}  // namespace tolman::view_sequences
