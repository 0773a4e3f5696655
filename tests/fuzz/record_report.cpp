// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: metrics, figures and page of a report on changed records. See edited_record.hpp.
#include "edited_record.hpp"
#include "input.hpp"
#include "report/page.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  fuzz::writeEditedRecord(folder.path(), fuzz::asText({data, size}));
  const auto refused = [](const Status& status) {
    fuzz::require(!status.message().empty(), "refused without a message");
    return 0;
  };
  const auto reader = record::RunReader::open(folder.path());
  if (!reader.isOk()) return refused(reader.status());
  auto run = report::readRun(*reader.value(), {}, 1);
  if (!run.isOk()) return refused(run.status());
  const auto page = report::makePage(*reader.value(), std::move(run).value());
  if (!page.isOk()) return refused(page.status());
  (void)evaluation::toJson(page.value().data.metrics).dump();
  fuzz::require(!report::html({page.value()}).empty(), "an empty page");
  return 0;
}
