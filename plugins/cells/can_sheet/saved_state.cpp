// SPDX-License-Identifier: BSD-3-Clause
#include "saved_state.hpp"

#include <cmath>

#include "tolman/state_stream.hpp"

namespace tolman::can_sheet {
namespace {

constexpr std::string_view kMagic = "TLMSHEET";
constexpr std::uint64_t kStateVersion = 1;
constexpr double kLargest = 1e15;                           // bounded so that squares are finite
constexpr std::int64_t kMaxCount = std::int64_t{1} << 62U;  // counters are incremented later

/// Reads numbers. `sound` is false after one that is out of bounds.
struct SoundReader {
  StateReader& reader;
  bool sound = true;

  void operator()(double& number) {
    number = reader.get<double>();
    sound = sound && std::abs(number) <= kLargest;  // false for NaN
  }
  void operator()(std::int64_t& number) {
    number = reader.get<std::int64_t>();
    sound = sound && number >= -1 && number < kMaxCount;
  }
  void operator()(bool& value) { value = reader.get<bool>(); }
};

struct Writer {
  StateWriter writer;
  template <class T>
  void operator()(const T& number) {
    writer.put(number);
  }
};

template <class Archive, class Matrix>
void matrix(Archive& archive, Matrix& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) archive(values.data()[i]);
}

template <class Archive, class Link>
void linkFields(Archive& archive, Link& link) {
  for (auto& phase : link.phases) matrix(archive, phase);
  archive(link.heading);
  archive(link.travel);
  archive(link.experience);
  matrix(archive, link.T_experience_template.matrix());
}

/// Saves or loads everything but sheets and links.
template <class Archive, class State>
void plainFields(Archive& archive, State& state) {
  archive(state.heading);
  matrix(archive, state.position);
  for (auto* number : {&state.travel, &state.travel_at_view, &state.travel_at_loop}) {
    archive(*number);
  }
  archive(state.experiences);
  archive(state.current);
  matrix(archive, state.T_experience_current.matrix());
  matrix(archive, state.T_made_current.matrix());
  archive(state.initialising);
  archive(state.new_part);
  archive(state.relocating);
}

bool readSheets(StateReader& reader, SheetState& state) {
  if (reader.get<std::int64_t>() != static_cast<std::int64_t>(state.sheets.size())) return false;
  bool sound = true;
  for (AttractorSheet& sheet : state.sheets) {
    if (reader.get<std::int64_t>() != sheet.units()) return false;
    std::vector<float> activity(sheet.activity().size());
    reader.getAll(std::span<float>(activity));
    sound = sheet.restore(activity) && sound;
  }
  return sound;
}

}  // namespace

Status saveState(const SheetState& state, std::ostream& stream) {
  Writer archive;
  archive(static_cast<std::int64_t>(state.sheets.size()));
  for (const AttractorSheet& sheet : state.sheets) {
    archive(static_cast<std::int64_t>(sheet.units()));
    archive.writer.putAll(sheet.activity());
  }
  plainFields(archive, state);
  archive(static_cast<std::int64_t>(state.links.size()));
  for (const auto& [id, link] : state.links) {
    archive(id);
    linkFields(archive, link);
  }
  return archive.writer.write(stream, kMagic, kStateVersion);
}

Status loadState(std::istream& stream, SheetState& state) {
  Result<StateReader> opened = StateReader::open(stream, kMagic, kStateVersion);
  if (!opened.isOk()) return opened.status();
  StateReader& reader = opened.value();
  SoundReader archive{reader};
  bool sound = readSheets(reader, state);
  plainFields(archive, state);
  std::int64_t count = 0;
  archive(count);
  for (std::int64_t i = 0; sound && i < count && reader.remaining() > 0; ++i) {
    std::int64_t id = 0;
    archive(id);
    ViewLink& link = state.links[id];
    link.phases.resize(state.sheets.size());
    linkFields(archive, link);
    sound = id >= 0 && link.experience >= 0 && link.experience < state.experiences;
  }
  sound = sound && archive.sound && static_cast<std::int64_t>(state.links.size()) == count &&
          state.current < state.experiences;
  if (sound && reader.complete()) return Status::ok();
  return Status::invalidInput(
      "the saved sheets are damaged, or have other modules or units than this configuration");
}

}  // namespace tolman::can_sheet
