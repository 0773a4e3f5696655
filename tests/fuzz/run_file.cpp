// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: run.json.
#include "input.hpp"
#include "record/run_directory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  const std::string_view text = fuzz::asText({data, size});
  folder.write("run.json", text);
  const auto json = record::RunDirectory::readRunFile(folder.path());
  (void)json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  (void)record::RunDirectory::wasKilled(folder.path());
  return 0;
}
