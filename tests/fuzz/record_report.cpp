// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: metrics, figures and page of a report on changed records. See edited_record.hpp.
#include "edited_record.hpp"
#include "input.hpp"
#include "report/page.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  fuzz::writeEditedRecord(folder.path(), fuzz::asText({data, size}));
  auto page = report::makePage(folder.path(), {});
  if (!page.isOk()) {
    fuzz::require(!page.status().message().empty(), "refused without a message");
    return 0;
  }
  (void)evaluation::toJson(page.value().data.metrics).dump();
  fuzz::require(!report::html({page.value()}).empty(), "an empty page");
  return 0;
}
