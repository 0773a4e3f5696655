// SPDX-License-Identifier: BSD-3-Clause
#include "saved_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tolman/state_stream.hpp"

namespace tolman::bayesian_attractor {
namespace {

constexpr std::string_view kMagic = "TLMBAYES";
constexpr std::uint64_t kStateVersion = 3;

/// Phases are worthless on a manifold of another size.
std::vector<double> manifold(const AttractorParameters& p) {
  return {p.period,
          p.metres_per_cell,
          p.energy_heading,
          p.energy_position,
          static_cast<double>(p.modules),
          p.module_ratio};
}

template <int Axes>
void put(StateWriter& writer, const PeriodicBump<Axes>& bump) {
  for (int axis = 0; axis < Axes; ++axis) writer.put(bump.mean(axis));
  writer.put(bump.precision);
}

template <int Axes>
PeriodicBump<Axes> getBump(StateReader& reader) {
  PeriodicBump<Axes> bump;
  for (int axis = 0; axis < Axes; ++axis) bump.mean(axis) = reader.get<double>();
  bump.precision = reader.get<double>();
  return bump;
}

template <int Axes>
void put(StateWriter& writer, const AttractorNetwork<Axes>& network) {
  put<Axes>(writer, network.integrator());
  put<Axes>(writer, network.calibration());
  put<Axes>(writer, network.injected());
}

template <int Axes>
void get(StateReader& reader, AttractorNetwork<Axes>& network) {
  const auto integrator = getBump<Axes>(reader);
  const auto calibration = getBump<Axes>(reader);
  const auto injected = getBump<Axes>(reader);
  network.restore(integrator, calibration, injected);
}

void put(StateWriter& writer, const Eigen::Isometry3d& T) {
  writer.putAll(std::span<const double>(T.data(), 16));
}

Eigen::Isometry3d getPose(StateReader& reader) {
  Eigen::Isometry3d T;
  reader.getAll(std::span<double>(T.data(), 16));
  return T;
}

void put(StateWriter& writer, const PlanarPose& pose) {
  for (const double number : {pose.x, pose.y, pose.theta}) writer.put(number);
}

PlanarPose getPlanar(StateReader& reader) {
  PlanarPose pose;
  for (double* number : {&pose.x, &pose.y, &pose.theta}) *number = reader.get<double>();
  return pose;
}

template <class Matrix>
void putMatrix(StateWriter& writer, const Matrix& matrix) {
  writer.putAll(std::span<const double>(matrix.data(), static_cast<std::size_t>(matrix.size())));
}

template <class Matrix>
void getMatrix(StateReader& reader, Matrix& matrix) {
  reader.getAll(std::span<double>(matrix.data(), static_cast<std::size_t>(matrix.size())));
}

void put(StateWriter& writer, const CellPose& pose) {
  writer.put(pose.heading);
  putMatrix(writer, pose.position);
  for (const Phase<2>& position : pose.further) putMatrix(writer, position);
}

CellPose getCellPose(StateReader& reader, std::size_t further_modules) {
  CellPose pose;
  pose.heading = reader.get<double>();
  getMatrix(reader, pose.position);
  pose.further.resize(further_modules);
  for (Phase<2>& position : pose.further) getMatrix(reader, position);
  return pose;
}

void put(StateWriter& writer, const PathMark& mark) {
  writer.put(mark.step);
  writer.put(mark.part);
  put(writer, mark.pose);
  putMatrix(writer, mark.turns);
  putMatrix(writer, mark.lengths);
  writer.put(mark.step_variance);
}

PathMark getMark(StateReader& reader) {
  PathMark mark;
  mark.step = reader.get<std::int64_t>();
  mark.part = reader.get<std::int64_t>();
  mark.pose = getPlanar(reader);
  getMatrix(reader, mark.turns);
  getMatrix(reader, mark.lengths);
  mark.step_variance = reader.get<double>();
  return mark;
}

void put(StateWriter& writer, const PathMemory& path) {
  const PathMemory::State state = path.state();
  put(writer, state.now);
  putMatrix(writer, state.least);
  putMatrix(writer, state.most);
  writer.put(static_cast<std::int64_t>(state.loops.size()));
  for (const ClosedLoop& loop : state.loops) {
    put(writer, loop.home);
    put(writer, loop.visit);
    put(writer, loop.offset.pose);
    putMatrix(writer, loop.offset.covariance);
  }
}

PathMemory::State getPath(StateReader& reader) {
  PathMemory::State state;
  state.now = getMark(reader);
  getMatrix(reader, state.least);
  getMatrix(reader, state.most);
  const auto count = reader.get<std::int64_t>();
  for (std::int64_t i = 0; i < count && reader.remaining() > 0; ++i) {
    ClosedLoop loop;
    loop.home = getMark(reader);
    loop.visit = getMark(reader);
    loop.offset.pose = getPlanar(reader);
    getMatrix(reader, loop.offset.covariance);
    state.loops.push_back(loop);
  }
  return state;
}

void put(StateWriter& writer, const std::deque<Relocation::Claim>& claims) {
  writer.put(static_cast<std::int64_t>(claims.size()));
  for (const Relocation::Claim& claim : claims) {
    put(writer, claim.learned);
    put(writer, claim.here);
    put(writer, claim.seen.pose);
    putMatrix(writer, claim.seen.covariance);
  }
}

std::deque<Relocation::Claim> getClaims(StateReader& reader) {
  std::deque<Relocation::Claim> claims;
  const auto count = reader.get<std::int64_t>();
  for (std::int64_t i = 0; i < count && reader.remaining() > 0; ++i) {
    Relocation::Claim claim;
    claim.learned = getMark(reader);
    claim.here = getMark(reader);
    claim.seen.pose = getPlanar(reader);
    getMatrix(reader, claim.seen.covariance);
    claims.push_back(claim);
  }
  return claims;
}

void put(StateWriter& writer, const ViewLinks& links) {
  writer.put(links.views());
  writer.put(links.previous());
  writer.put(links.settled());
  writer.put(static_cast<std::int64_t>(links.links().size()));
  for (const auto& [id, link] : links.links()) {
    writer.put(id);
    put(writer, link.learned);
    writer.put(link.order);
    writer.put(link.experience);
    put(writer, link.T_experience_template);
    put(writer, link.mark);
    writer.put(link.decay);
    writer.put(link.last_view);
  }
}

void get(StateReader& reader, ViewLinks& links, std::size_t further_modules) {
  const auto views = reader.get<std::int64_t>();
  const auto previous = reader.get<std::int64_t>();
  const auto settled = reader.get<std::int64_t>();
  const auto count = reader.get<std::int64_t>();
  std::map<std::int64_t, ViewLink> read;
  for (std::int64_t i = 0; i < count && reader.remaining() > 0; ++i) {
    ViewLink& link = read[reader.get<std::int64_t>()];
    link.learned = getCellPose(reader, further_modules);
    link.order = reader.get<std::int64_t>();
    link.experience = reader.get<std::int64_t>();
    link.T_experience_template = getPose(reader);
    link.mark = getMark(reader);
    link.decay = reader.get<double>();
    link.last_view = reader.get<std::int64_t>();
  }
  links.restore(views, previous, settled, read);
}

void put(StateWriter& writer, const ExperienceLog::State& log) {
  writer.put(log.current);
  put(writer, log.T_experience_current);
  writer.put(log.travel);
  writer.put(log.travel_at_loop);
  writer.put(std::int64_t{log.woken});
  writer.put(static_cast<std::int64_t>(log.travel_when_left.size()));
  writer.putAll(std::span<const double>(log.travel_when_left));
}

ExperienceLog::State getLog(StateReader& reader) {
  ExperienceLog::State log;
  log.current = reader.get<std::int64_t>();
  log.T_experience_current = getPose(reader);
  log.travel = reader.get<double>();
  log.travel_at_loop = reader.get<double>();
  log.woken = reader.get<std::int64_t>() != 0;
  const auto count = static_cast<std::size_t>(reader.get<std::int64_t>());
  if (count != reader.remaining() / sizeof(double)) return log;  // complete() will tell
  log.travel_when_left.resize(count);
  reader.getAll(std::span<double>(log.travel_when_left));
  return log;
}

/// Indices within bounds, and numbers that are numbers: a file may be anybody's.
bool isSound(const AttractorState& state) {
  const ExperienceLog::State log = state.log.state();
  const auto experiences = static_cast<std::int64_t>(log.travel_when_left.size());
  const auto known = [&](std::int64_t id) { return id >= 0 && id < experiences; };
  bool sound = (log.current == -1 && experiences == 0) || known(log.current);
  sound = sound && std::isfinite(log.travel) && log.T_experience_current.matrix().allFinite();
  sound = sound && std::isfinite(state.cells.estimate().heading) &&
          state.cells.estimate().position.isFinite().all();
  for (const auto& [id, link] : state.links.links()) {
    sound = sound && id >= 0 && known(link.experience) && std::isfinite(link.learned.heading) &&
            link.learned.position.isFinite().all() &&
            std::ranges::all_of(link.learned.further,
                                [](const Phase<2>& p) { return p.isFinite().all(); }) &&
            link.T_experience_template.matrix().allFinite();
  }
  return sound && state.evidence.counts().right >= 0 && state.evidence.counts().views >= 0;
}

}  // namespace

Status saveState(const AttractorParameters& parameters, const AttractorState& state,
                 std::ostream& stream) {
  StateWriter writer;
  writer.putAll(std::span<const double>(manifold(parameters)));
  put<1>(writer, state.cells.ring());
  put<2>(writer, state.cells.torus());
  for (const GridTorus& torus : state.cells.further()) put<2>(writer, torus);
  writer.put(state.cells.support().views);
  writer.put(state.cells.support().unsupported);
  put(writer, state.links);
  put(writer, state.path);
  writer.put(state.evidence.counts().views);
  writer.put(state.evidence.counts().right);
  put(writer, state.relocation.claims());
  writer.put(std::int64_t{state.initialising});
  put(writer, state.log.state());
  return writer.write(stream, kMagic, kStateVersion);
}

Status loadState(const AttractorParameters& parameters, std::istream& stream,
                 AttractorState& state) {
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  StateReader& reader = opened.value();
  std::vector<double> saved = manifold(parameters);
  reader.getAll(std::span<double>(saved));
  if (saved != manifold(parameters)) {
    return Status::invalidInput(
        "the saved cells have another period, metres_per_cell or energy than configured");
  }
  get<1>(reader, state.cells.ring());
  get<2>(reader, state.cells.torus());
  for (GridTorus& torus : state.cells.further()) get<2>(reader, torus);
  SpatialCells::Support support;
  support.views = reader.get<std::int64_t>();
  support.unsupported = reader.get<std::int64_t>();
  state.cells.restore(support);
  get(reader, state.links, state.cells.further().size());
  state.path.restore(getPath(reader));
  ViewEvidence::Counts counts;
  counts.views = reader.get<std::int64_t>();
  counts.right = reader.get<std::int64_t>();
  state.evidence.restore(counts);
  state.relocation.restore(getClaims(reader));
  state.initialising = reader.get<std::int64_t>() != 0;
  state.log.restore(getLog(reader));
  if (!reader.complete()) return Status::invalidInput("the saved state is damaged: wrong length");
  if (!isSound(state)) {
    return Status::invalidInput("the saved state is damaged: numbers that cannot be");
  }
  return Status::ok();
}

}  // namespace tolman::bayesian_attractor
