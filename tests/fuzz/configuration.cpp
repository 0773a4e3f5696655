// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the whole loader of configurations. The input is several files, divided by lines
// "%%": main.yaml, a.yaml, b.yaml, c.yaml, and one --set on each line of the fifth. Systems without
// problems are written as config.resolved.yaml and loaded again.
#include <array>
#include <sstream>

#include "config/loader.hpp"
#include "config/system_config.hpp"
#include "config/toy_system.hpp"
#include "input.hpp"

namespace {

using namespace tolman;

struct Checked {
  config::SystemConfig system;
  config::StageValues values;
  config::Problems problems;
};

Checked check(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const auto environment = test::environmentOf({{"NUMBER", "3"}, {"TEXT", "some: [text"}});
  const config::Loaded loaded = config::load(file, overrides, environment);
  Checked checked;
  checked.problems = loaded.problems;
  checked.system = config::parse(loaded, checked.problems);
  for (const config::StageConfig& stage : checked.system.stages) {
    checked.values[stage.instance] = config::check(stage, test::toySchema(stage.plugin),
                                                   checked.system.folders, checked.problems);
  }
  for (const config::Problem& problem : checked.problems) {
    fuzz::require(!problem.message.empty(), "a problem without a message");
  }
  return checked;
}

std::vector<std::string> linesOf(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kNames = {"main.yaml", "a.yaml", "b.yaml", "c.yaml"};
  const fuzz::ScratchFolder folder;
  const auto parts = fuzz::partsOf(fuzz::asText({data, size}));
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < parts.size() && i <= kNames.size(); ++i) {
    if (i < kNames.size()) folder.write(kNames[i], parts[i]);
    if (i == kNames.size()) overrides = linesOf(parts[i]);
  }
  const Checked checked = check(folder.path() / "main.yaml", overrides);
  (void)format(checked.problems);
  (void)explain(checked.system, checked.values);
  const std::string resolved = resolvedYaml(checked.system, checked.values);
  if (!checked.problems.empty()) return 0;
  folder.write("resolved.yaml", resolved);
  const Checked again = check(folder.path() / "resolved.yaml", {});
  fuzz::require(again.problems.empty(), "config.resolved.yaml has problems");
  fuzz::require(resolvedYaml(again.system, again.values) == resolved,
                "config.resolved.yaml is another when it is loaded");
  return 0;
}
