// SPDX-License-Identifier: BSD-3-Clause
#include "app/results.hpp"

#include <stdexcept>

#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"
#include "report/map_picture.hpp"
#include "report/run_data.hpp"

namespace tolman::app {
namespace {

void must(const Status& status) {
  if (!status.isOk()) throw std::runtime_error(status.message());
}

}  // namespace

Result<evaluation::Metrics> writeResults(const std::filesystem::path& directory,
                                         const config::EvaluationSettings& settings) {
  const auto opened = record::RunReader::open(directory);
  if (!opened.isOk()) return opened.status();
  const record::RunReader& reader = *opened.value();
  try {
    must(record::exportRun(reader, directory).status());
    const auto run = report::readRun(reader, settings);
    must(run.status());
    const report::RunData& data = run.value();
    must(record::writeAtomically(directory / "metrics.json",
                                 evaluation::toJson(data.metrics).dump(2) + "\n"));
    const std::string picture =
        report::svgText({data.name, data.truth, data.odometry, data.map, data.graph});
    must(record::writeAtomically(directory / "map.svg", picture));
    must(record::writeResultsDigest(directory));
    return data.metrics;
  } catch (const std::exception& error) {
    return Status::invalidInput(error.what());
  }
}

}  // namespace tolman::app
