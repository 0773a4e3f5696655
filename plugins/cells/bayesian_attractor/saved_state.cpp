// SPDX-License-Identifier: BSD-3-Clause
#include "saved_state.hpp"

#include <algorithm>

#include "tolman/state_stream.hpp"

namespace tolman::bayesian_attractor {
namespace {

constexpr std::string_view kMagic = "TLMBAYES";
constexpr std::uint64_t kStateVersion = 10;

/// Writes each number that it is called with.
class Saver {
 public:
  static constexpr bool kLoads = false;
  template <class T>
  void operator()(const T& number) requires std::is_arithmetic_v<T> {
    writer.put(number);
  }
  StateWriter writer;
};

/// Reads into each number that it is called with.
class Loader {
 public:
  static constexpr bool kLoads = true;
  explicit Loader(StateReader& source) : reader(source) {}
  template <class T>
  void operator()(T& number) requires std::is_arithmetic_v<T> {
    number = reader.get<T>();
  }
  StateReader& reader;
};

template <class Archive, class Matrix>
void numbers(Archive& archive, Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) archive(*(matrix.data() + i));
}

/// Number of elements: `size` when saving, the number in the file when loading.
template <class Archive>
std::int64_t counted(Archive& archive, std::size_t size) {
  auto count = static_cast<std::int64_t>(size);
  archive(count);
  return count;
}

template <class Archive>
bool goesOn(const Archive& archive) {
  if constexpr (Archive::kLoads) return archive.reader.remaining() > 0;
  return true;
}

template <class Archive, class Pattern>
void pattern(Archive& archive, Pattern& pattern) {
  archive(pattern.heading);
  numbers(archive, pattern.phases);
  numbers(archive, pattern.heights);
}

template <class Archive, class Errors>
void pathErrors(Archive& archive, Errors& errors) {
  numbers(archive, errors.effect);
  numbers(archive, errors.applied);
}

template <class Archive, class Bump>
void bump(Archive& archive, Bump& bump) {
  pattern(archive, bump.centre);
  numbers(archive, bump.covariance);
  archive(bump.height_variance);
  pathErrors(archive, bump.errors);
}

template <class Archive, class Pose>
void pose(Archive& archive, Pose& pose) {
  for (auto* number : {&pose.x, &pose.y, &pose.theta}) archive(*number);
}

template <class Archive>
void history(Archive& archive, std::vector<PathPiece>& pieces, PlanarPose& here) {
  const std::int64_t count = counted(archive, pieces.size());
  if constexpr (Archive::kLoads) pieces.clear();
  for (std::int64_t i = 0; i < count && goesOn(archive); ++i) {
    if constexpr (Archive::kLoads) pieces.emplace_back();
    PathPiece& piece = pieces[static_cast<std::size_t>(i)];
    archive(piece.origin);
    archive(piece.unknown);
    pose(archive, piece.motion);
    numbers(archive, piece.noise);
    numbers(archive, piece.effect);
    archive(piece.length);
    pose(archive, piece.begin);
  }
  pose(archive, here);
}

template <class Archive, class State>
void network(Archive& archive, State& state, const Bump& fresh) {
  bump(archive, state.integrator);
  bump(archive, state.stretch_start);
  for (auto* number : {&state.part, &state.parts, &state.stretch, &state.views, &state.right}) {
    archive(*number);
  }
  archive(state.bumps);
  for (auto& estimate : state.path.estimates) {
    numbers(archive, estimate.mean);
    numbers(archive, estimate.covariance);
    archive(estimate.log_weight);
  }
  numbers(archive, state.path.log_factors);
  if constexpr (Archive::kLoads) state.path.mix();
  std::vector<PathPiece> pieces = state.history.pieces();
  PlanarPose here = state.history.here();
  history(archive, pieces, here);
  if constexpr (Archive::kLoads) state.history.restore(std::move(pieces), here);
  archive(state.travel);
  numbers(archive, state.explored_min);
  numbers(archive, state.explored_max);
  const std::int64_t count = counted(archive, state.calibration.size());
  for (std::int64_t i = 0; i < count && goesOn(archive); ++i) {
    if constexpr (Archive::kLoads) state.calibration.push_back({.bump = fresh});
    auto& hypothesis = state.calibration[static_cast<std::size_t>(i)];
    archive(hypothesis.id);
    bump(archive, hypothesis.bump);
    archive(hypothesis.energy);
    archive(hypothesis.part);
    archive(hypothesis.views);
    archive(hypothesis.last_injection_travel);
  }
}

template <class Archive, class Link>
void link(Archive& archive, Link& link) {
  pattern(archive, link.learned.pattern);
  archive(link.learned.part);
  archive(link.learned.stretch);
  numbers(archive, link.learned.covariance);
  archive(link.learned.height_variance);
  pathErrors(archive, link.learned.errors);
  archive(link.learned.piece);
  archive(link.travel);
  archive(link.experience);
  numbers(archive, link.T_experience_template.matrix());
}

template <class Archive, class Waiting>
void waitingLoops(Archive& archive, Waiting& list) {
  const std::int64_t count = counted(archive, list.size());
  for (std::int64_t i = 0; i < count && goesOn(archive); ++i) {
    if constexpr (Archive::kLoads) list.emplace_back();
    auto& waiting = list[static_cast<std::size_t>(i)];
    archive(waiting.bump);
    archive(waiting.travel);
    archive(waiting.loop.frame);
    archive(waiting.loop.experience);
    numbers(archive, waiting.loop.T_experience_camera.matrix());
    numbers(archive, waiting.loop.covariance);
  }
}

template <class Archive, class Log>
void experiences(Archive& archive, Log& log) {
  archive(log.current);
  numbers(archive, log.T_experience_current.matrix());
  numbers(archive, log.T_made_current.matrix());
  archive(log.travel);
  archive(log.travel_at_loop);
  archive(log.new_part);
  const std::int64_t count = counted(archive, log.travel_when_left.size());
  for (std::int64_t i = 0; i < count && goesOn(archive); ++i) {
    if constexpr (Archive::kLoads) log.travel_when_left.push_back(0);
    archive(log.travel_when_left[static_cast<std::size_t>(i)]);
  }
}

/// Whether all experiences that are referred to exist, and all ids and counts are valid.
bool isSound(const AttractorState& state) {
  const ExperienceLog::State log = state.log.state();
  const auto known = static_cast<std::int64_t>(log.travel_when_left.size());
  const auto exists = [&](std::int64_t id) { return id >= 0 && id < known; };
  const std::vector<PathPiece>& pieces = state.network.state().history.pieces();
  const auto traced = [&](const ViewLink& link) {
    return link.learned.piece >= 0 && link.learned.piece < static_cast<std::int64_t>(pieces.size());
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].origin >= static_cast<std::int64_t>(k)) return false;
  }
  if (!(log.current == -1 && known == 0) && !exists(log.current)) return false;
  for (const auto& [id, storeys] : state.links) {
    if (id < 0 || !std::ranges::all_of(storeys, exists, &ViewLink::experience) ||
        !std::ranges::all_of(storeys, traced)) {
      return false;
    }
  }
  for (const WaitingLoop& waiting : state.waiting.list()) {
    if (waiting.loop.frame < 0 || !exists(waiting.loop.experience)) return false;
  }
  const NetworkState& network = state.network.state();
  return !pieces.empty() && network.parts > network.part && network.part >= 0 &&
         network.right >= 0 && network.views >= 0;
}

void saveLinks(Saver& saver, const AttractorState& state) {
  counted(saver, state.links.size());
  for (const auto& [id, storeys] : state.links) {
    saver(id);
    counted(saver, storeys.size());
    for (const ViewLink& linked : storeys) link(saver, linked);
  }
}

void loadLinks(Loader& loader, AttractorState& state, const Bump& fresh) {
  const std::int64_t count = counted(loader, 0);
  for (std::int64_t i = 0; i < count && goesOn(loader); ++i) {
    std::vector<ViewLink>& storeys = state.links[loader.reader.get<std::int64_t>()];
    const std::int64_t known = counted(loader, 0);
    for (std::int64_t storey = 0; storey < known && goesOn(loader); ++storey) {
      link(loader, storeys.emplace_back(ViewLink{.learned = {.pattern = fresh.centre}}));
    }
  }
}

template <class Archive, class State>
void upright(Archive& archive, State& state) {
  numbers(archive, state.forward);
  archive(state.path);
  for (auto* matrix : {&state.turns, &state.R_first_camera, &state.R_turn_camera}) {
    numbers(archive, *matrix);
  }
}

/// Period of the smallest vertical module, m; 0 without vertical modules.
double heightPeriod(const AttractorState& state) {
  const HeightCode& height = state.network.code().height();
  return height.modules() > 0 ? height.period(0) : 0;
}

}  // namespace

Status saveState(const AttractorState& state, std::ostream& stream) {
  Saver saver;
  saver(state.network.code().grid().period(0));
  saver(std::int64_t{state.network.code().grid().modules()});
  saver(heightPeriod(state));
  network(saver, state.network.state(), {});
  saveLinks(saver, state);
  const ExperienceLog::State log = state.log.state();
  experiences(saver, log);
  waitingLoops(saver, state.waiting.list());
  upright(saver, state.upright);
  saver(state.initialising);
  return saver.writer.write(stream, kMagic, kStateVersion);
}

Status loadState(std::istream& stream, AttractorState& state) {
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  Loader loader(opened.value());
  const GridCode& grid = state.network.code().grid();
  if (loader.reader.get<double>() != grid.period(0) ||
      loader.reader.get<std::int64_t>() != grid.modules() ||
      loader.reader.get<double>() != heightPeriod(state)) {
    return Status::invalidInput("the saved cells have another period or number of modules");
  }
  const Bump fresh{state.network.code().origin()};
  NetworkState loaded = state.network.state();
  network(loader, loaded, fresh);
  state.network.restore(loaded);
  loadLinks(loader, state, fresh);
  ExperienceLog::State log;
  experiences(loader, log);
  state.log.restore(log);
  std::vector<WaitingLoop> waiting;
  waitingLoops(loader, waiting);
  state.waiting.restore(std::move(waiting));
  upright(loader, state.upright);
  loader(state.initialising);
  if (!loader.reader.complete()) {
    return Status::invalidInput("the saved state is damaged: wrong length");
  }
  if (!isSound(state)) {
    return Status::invalidInput("the saved state is damaged: numbers that cannot be");
  }
  return Status::ok();
}

}  // namespace tolman::bayesian_attractor
