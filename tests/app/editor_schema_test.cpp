// SPDX-License-Identifier: BSD-3-Clause
// The schema of `tolman plugins describe --json-schema` accepts and refuses the same configurations
// as the host. It is checked with another validator (python3-jsonschema).
#include <catch2/catch.hpp>
#include <fstream>
#include <utility>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = inSource("");
constexpr const char* kNoValidator = "SKIPPED: no python3-jsonschema and python3-yaml";

void writeText(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

class Editor {
 public:
  Editor() {
    const Finished made = tolman::test::tolman({"plugins", "describe", "--json-schema"});
    REQUIRE(made.exit_code == 0);
    writeText(folder_.path() / "schema.json", made.out);
  }
  Finished judge(const fs::path& file) const {
    return run({"python3", (kSource / "tests/app/validate_schema.py").string(),
                (folder_.path() / "schema.json").string(), file.string()});
  }
  /// A text that is not in a file yet.
  Finished judgeText(const std::string& text) const {
    writeText(folder_.path() / "typed.yaml", text);
    return judge(folder_.path() / "typed.yaml");
  }
  bool hasValidator() const { return judge(kSource / "configs/demo.yaml").exit_code != 77; }

 private:
  TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  INFO(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("all configurations of this repository fit the schema") {
  const Editor editor;
  if (!editor.hasValidator()) {
    WARN(kNoValidator);
    return;
  }
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "configs")) {
    if (entry.path().extension() != ".yaml") continue;
    const fs::path folder = entry.path().parent_path().filename();
    // Sweeps and bases, stages alone, and the sweeps of `tolman init`.
    if (folder == "experiments" || folder == "init" || folder == "try") continue;
    const Finished judged = editor.judge(entry.path());
    INFO(judged.out << judged.err);
    CHECK(judged.exit_code == 0);
    ++files;
  }
  CHECK(files >= 7);
}

TEST_CASE("what the host refuses does not fit the schema, at the same place") {
  const Editor editor;
  if (!editor.hasValidator()) {
    WARN(kNoValidator);
    return;
  }
  const std::string demo = readText(kSource / "configs/demo.yaml");
  const std::pair<std::string, std::string> broken[] = {
      {replaced(demo, "plugin: view_sequences", "plugin: view_sequnces"), "$.place.plugin: "},
      {replaced(demo, "route: block", "ruote: block"), "'ruote' was unexpected"},
      {replaced(demo, "scale: 0.5", "scale: 50"), "$.source.scale: 50 is greater than the maximum"},
      {replaced(demo, "scale: 0.5", "scale: half"), "$.source.scale: 'half' does not match"},
      {replaced(demo, "name: demo", "nam: demo"), "'nam' was unexpected"},
      {replaced(demo, "cells:\n  plugin: bayesian_attractor\n", ""), "'cells' is a required"},
      {demo + "pipeline: {mode: lossles}\n", "$.pipeline.mode: "},
      {demo + "seed: -1\n", "$.seed: -1 is less than the minimum"},
  };
  for (const auto& [text, finding] : broken) {
    const Finished judged = editor.judgeText(text);
    INFO(finding << "\n" << judged.out << judged.err);
    CHECK(judged.exit_code == 1);
    CHECK(contains(judged.out, finding));
  }
}

TEST_CASE("what the host takes fits, also where files and environment complete it") {
  const Editor editor;
  if (!editor.hasValidator()) {
    WARN(kNoValidator);
    return;
  }
  const std::string demo = readText(kSource / "configs/demo.yaml");
  for (const std::string& text :
       {std::string("extends: demo.yaml\nsource: {scale: 1}\n"),
        std::string("extends: [a.yaml, b.yaml]\nsource: {plugin: kitti}\nmap: {name: mine}\n"),
        replaced(demo, "scale: 0.5", "scale: ${SCALE:-0.5}"),
        replaced(demo, "view_sequences", "${PLACE:-view_sequences}"),
        demo + "evaluation: {segments: [5, 10]}\n", replaced(demo, "name: demo", "name: 06")}) {
    const Finished judged = editor.judgeText(text);
    INFO(text << "\n" << judged.out << judged.err);
    CHECK(judged.exit_code == 0);
  }
}

TEST_CASE("describe without an id is for the schema alone") {
  const Finished finished = tolman::test::tolman({"plugins", "describe", "--markdown"});
  CHECK(finished.exit_code == 2);
  CHECK(contains(finished.err, "id is required"));
}

TEST_CASE("several plugins are described one after the other, as JSON in a list") {
  const Finished text = tolman::test::tolman({"plugins", "describe", "kitti", "progress"});
  CHECK(contains(text.out, "kitti "));
  CHECK(contains(text.out, "\n\nprogress "));
  const Finished json =
      tolman::test::tolman({"--json", "plugins", "describe", "kitti", "progress"});
  const auto plugins = nlohmann::json::parse(json.out);
  REQUIRE(plugins.size() == 2);
  CHECK(plugins[1]["id"] == "progress");
}
