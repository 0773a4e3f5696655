// SPDX-License-Identifier: BSD-3-Clause
#include "engine/program_changes.hpp"

#include <catch2/catch.hpp>

using tolman::Role;
using tolman::run::changedProgramFiles;
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

namespace {

/// A run.json whose cells are the program /a/cells.py, with the digests of its modules.
Json runOf(const Json& modules, const char* digest = "1", const char* role = "cells") {
  Json cells = {{"role", role}, {"program", "/a/cells.py"}, {"program_sha256", digest}};
  if (!modules.empty()) cells["program_files"] = modules;
  return {{"plugins", {{{"role", "source"}, {"id", "kitti"}}, cells}}};
}

Names changed(const Json& before, const Json& now) {
  return changedProgramFiles(before, now, {Role::Source, Role::Cells});
}

}  // namespace

TEST_CASE("a program and its modules are compared, also modules of one run only") {
  const Json modules = {{"/a/x.py", "2"}, {"/a/y.py", "3"}};
  CHECK(changed(runOf(modules), runOf(modules)).empty());
  CHECK(changed(runOf({}), runOf({})).empty());
  CHECK(changed(runOf(modules), runOf(modules, "9")) == Names{"/a/cells.py"});
  const Json edited = {{"/a/x.py", "2"}, {"/a/y.py", "9"}};
  CHECK(changed(runOf(modules), runOf(edited, "9")) == Names{"/a/cells.py", "/a/y.py"});
  CHECK(changed(runOf(modules), runOf({{"/a/x.py", "2"}})) == Names{"/a/y.py"});
  CHECK(changed(runOf({{"/a/x.py", "2"}}), runOf(modules)) == Names{"/a/y.py"});
  CHECK(changed(runOf(modules), runOf({})) == Names{"/a/x.py", "/a/y.py"});
}

TEST_CASE("a library, and those that it brings along, are compared by their contents") {
  const auto run = [](const char* file, const char* digest, const char* brought) {
    return Json{{"plugins",
                 {{{"role", "cells"},
                   {"file", file},
                   {"sha256", digest},
                   {"program_files", {{"/a/libhelper.so", brought}}}}}}};
  };
  const Json before = run("/a/cells.so", "1", "2");
  CHECK(changed(before, before).empty());
  CHECK(changed(before, run("/b/cells.so", "1", "2")).empty());
  CHECK(changed(before, run("/a/cells.so", "9", "2")) == Names{"/a/cells.so"});
  CHECK(changed(before, run("/a/cells.so", "1", "9")) == Names{"/a/libhelper.so"});
}

TEST_CASE("modules that are installed elsewhere are the same") {
  CHECK(changed(runOf({{"/a/x.py", "2"}}), runOf({{"/b/x.py", "2"}})).empty());
  CHECK(changed(runOf({{"/a/x.py", "2"}}), runOf({{"/b/x.py", "9"}})) ==
        Names{"/b/x.py", "/a/x.py"});
}

TEST_CASE("only the named roles are compared, and a damaged run.json is no error") {
  CHECK(changed(runOf({}, "1", "observer"), runOf({}, "9", "observer")).empty());
  const Json now = runOf({{"/a/x.py", "2"}});
  for (const char* damaged : {"null", "[]", "{\"plugins\": 3}", "{\"plugins\": [3, \"x\"]}",
                              "{\"plugins\": [{\"role\": [1]}]}"}) {
    CHECK(changed(Json::parse(damaged), now).empty());
  }
  Json before = now;
  before["plugins"][1]["program_files"] = "x";
  CHECK(changed(before, now) == Names{"/a/x.py"});
}
