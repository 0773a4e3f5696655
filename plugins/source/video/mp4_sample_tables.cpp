// SPDX-License-Identifier: BSD-3-Clause
#include "mp4_sample_tables.hpp"

#include <algorithm>

namespace tolman::video {
namespace {

/// Number at `offset` of a box's content, 0 beyond the end of the box.
std::uint64_t field(ContainerBytes& file, const Box& box, std::uint64_t offset) {
  if (offset + 4 > box.end - box.content) return 0;
  return file.number(box.content + offset, 4).value_or(0);
}

/// Samples by the list of durations: pairs of count and duration.
std::uint64_t timedSamples(ContainerBytes& file, const Box& durations) {
  constexpr std::uint64_t kEntry = 8;
  const std::uint64_t most = (durations.end - durations.content) / kEntry;
  const std::uint64_t entries = std::min(field(file, durations, 4), most);
  std::uint64_t samples = 0;
  for (std::uint64_t i = 0; i < entries; ++i) samples += field(file, durations, 8 + i * kEntry);
  return samples;
}

struct PlacedSamples {
  std::uint64_t all = 0;
  std::uint64_t in_last_chunk = 0;  ///< of which some writers fill only a part
};

/// Samples that fit into `chunks` by the list of first chunk, samples per chunk, description.
PlacedSamples placedSamples(ContainerBytes& file, const Box& layout, std::uint64_t chunks) {
  constexpr std::uint64_t kEntry = 12;
  const std::uint64_t most = (layout.end - layout.content) / kEntry;
  const std::uint64_t entries = std::min(field(file, layout, 4), most);
  PlacedSamples samples;
  for (std::uint64_t i = 0; i < entries; ++i) {
    const std::uint64_t at = 8 + i * kEntry;
    const std::uint64_t first = field(file, layout, at);
    const std::uint64_t next = i + 1 < entries ? field(file, layout, at + kEntry) : chunks + 1;
    samples.in_last_chunk = field(file, layout, at + 4);
    if (first >= 1 && next > first) samples.all += (next - first) * samples.in_last_chunk;
  }
  return samples;
}

std::string tell(const char* table, std::uint64_t count, std::uint64_t sizes) {
  return "is damaged: its table of " + std::string(table) + " has " + std::to_string(count) +
         " pictures, and that of their sizes " + std::to_string(sizes);
}

}  // namespace

std::string defectOfSampleTables(ContainerBytes& file, const Box& track) {
  const auto tables = findBox(file, track, {"mdia", "minf", "stbl"});
  if (!tables) return {};
  const auto sizes = findBox(file, *tables, {"stsz"});
  const auto layout = findBox(file, *tables, {"stsc"});
  auto places = findBox(file, *tables, {"stco"});
  if (!places) places = findBox(file, *tables, {"co64"});
  const auto durations = findBox(file, *tables, {"stts"});
  if (!sizes || !layout || !places || !durations) return {};
  const std::uint64_t count = field(file, *sizes, 8);
  const PlacedSamples placed = placedSamples(file, *layout, field(file, *places, 4));
  const bool fits =
      placed.all >= count && placed.all - count < std::max<std::uint64_t>(1, placed.in_last_chunk);
  if (!fits) return tell("places", placed.all, count);
  const std::uint64_t timed = timedSamples(file, *durations);
  // One more is the end of the last picture, which some writers give an entry of its own.
  const bool has_times = timed == count || timed == count + 1;
  return has_times ? "" : tell("times", timed, count);
}

}  // namespace tolman::video
