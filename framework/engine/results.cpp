// SPDX-License-Identifier: BSD-3-Clause
#include "engine/results.hpp"

#include <utility>

#include "config/json_text.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"
#include "report/map_picture.hpp"

namespace tolman::run {

Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings, std::uint64_t seed) {
  auto opened = record::RunReader::open(directory);
  if (!opened.isOk()) return opened.status();
  const record::RunReader& reader = *opened.value();
  // Another program, or a disk, may have changed rows while the run went on.
  Status status = record::checkRows(reader, {});
  if (status.isOk()) status = record::exportRun(reader, directory).status();
  if (!status.isOk()) return status;
  auto run = report::readRun(reader, settings, seed);
  if (!run.isOk()) return run.status();
  const report::RunData& data = run.value();
  status = record::writeAtomically(directory / "metrics.json",
                                   config::jsonText(evaluation::toJson(data.metrics), 2) + "\n");
  if (status.isOk()) {
    status = record::writeAtomically(directory / "map.svg",
                                     report::svgText(report::pictureOf(data, data.name)));
  }
  if (status.isOk()) status = record::writeResultsDigest(directory);
  if (!status.isOk()) return status;
  return Results{std::move(opened).value(), std::move(run).value()};
}

}  // namespace tolman::run
