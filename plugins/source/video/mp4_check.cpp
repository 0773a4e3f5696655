// SPDX-License-Identifier: BSD-3-Clause
#include "mp4_check.hpp"

#include "mp4_boxes.hpp"
#include "mp4_fragments.hpp"
#include "mp4_sample_tables.hpp"

namespace tolman::video {
namespace {

/// Length of all fragments by the header (boxes `mvhd` and `mehd`, sections 8.2.2 and 8.8.2).
std::optional<double> promisedSeconds(ContainerBytes& file, const Box& movie) {
  const auto head = findBox(file, movie, {"mvhd"});
  const auto end = findBox(file, movie, {"mvex", "mehd"});
  if (!head || !end) return std::nullopt;
  const auto isLong = [&](const Box& box) { return file.number(box.content, 1) == 1; };
  const auto units_per_second = file.number(head->content + (isLong(*head) ? 20 : 12), 4);
  const auto units = file.number(end->content + 4, isLong(*end) ? 8 : 4);
  if (units_per_second.value_or(0) == 0 || units.value_or(0) == 0) return std::nullopt;
  return static_cast<double>(*units) / static_cast<double>(*units_per_second);
}

std::string defectOfTables(ContainerBytes& file, const Box& movie) {
  return visitBoxes(file, movie.content, movie.end, [&](const Box& box) -> std::string {
    if (box.type != boxType("trak")) return {};
    const auto handler = findBox(file, box, {"mdia", "hdlr"});
    const bool has_pictures = handler && file.number(handler->content + 8, 4) == boxType("vide");
    return has_pictures ? defectOfSampleTables(file, box) : "";
  });
}

}  // namespace

ContainerCheck checkMp4(ContainerBytes& file) {
  const auto movie = findBox(file, 0, file.size(), boxType("moov"));
  if (!movie) return {};
  if (const auto second = findBox(file, movie->end, file.size(), boxType("moov"))) {
    return {"has a second header, the box " + nameOf(*second) +
                ", as of two videos that were joined byte by byte: only the first is read",
            std::nullopt};
  }
  ContainerCheck check{defectOfTables(file, *movie), std::nullopt};
  const bool in_fragments = findBox(file, *movie, {"mvex"}).has_value();
  if (!check.defect.empty() || !in_fragments) return check;
  const DefaultSizes tracks = tracksOf(file, *movie);
  if (tracks.size() == 1) check.promised_s = promisedSeconds(file, *movie);
  check.defect = defectOfFragments(file, tracks);
  return check;
}

}  // namespace tolman::video
