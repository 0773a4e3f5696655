// SPDX-License-Identifier: BSD-3-Clause
// The files that plugins are made of, compared between two run.json.
#include <catch2/catch.hpp>

#include "engine/provenance.hpp"

using tolman::Role;
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

namespace {

/// A run.json whose cells are this library, which brings along other files.
Json runOf(const char* file, const char* digest, const Json& brought, const char* role = "cells") {
  Json cells = {{"role", role}, {"file", file}, {"sha256", digest}};
  if (!brought.empty()) cells["program_files"] = brought;
  return {{"plugins", {cells}}};
}

Names changed(const Json& before, const Json& now) {
  return tolman::engine::changedProgramFiles(before, now, {Role::Source, Role::Cells});
}

}  // namespace

TEST_CASE("libraries and what they bring along are compared by their contents") {
  const Json brought = {{"/a/x.py", "2"}, {"/a/y.py", "3"}};
  const Json before = runOf("/a/cells.so", "1", brought);
  CHECK(changed(before, before).empty());
  CHECK(changed(before, runOf("/b/cells.so", "1", brought)).empty());  // installed elsewhere
  CHECK(changed(before, runOf("/a/cells.so", "9", brought)) == Names{"/a/cells.so"});
  const Json edited = {{"/a/x.py", "2"}, {"/a/y.py", "9"}};
  CHECK(changed(before, runOf("/a/cells.so", "1", edited)) == Names{"/a/y.py"});
  const Json fewer = runOf("/a/cells.so", "1", {{"/a/x.py", "2"}});
  CHECK(changed(before, fewer) == Names{"/a/y.py"});
  CHECK(changed(fewer, before) == Names{"/a/y.py"});
}

TEST_CASE("a program has its own digest") {
  const auto run = [](const char* digest) {
    Json json = runOf("/a/python.so", "1", {});
    json["plugins"][0]["program"] = "/a/cells.py";
    json["plugins"][0]["program_sha256"] = digest;
    return json;
  };
  CHECK(changed(run("2"), run("2")).empty());
  CHECK(changed(run("2"), run("3")) == Names{"/a/cells.py"});
}

TEST_CASE("only the named roles are compared, and a foreign run.json is no error") {
  CHECK(changed(runOf("/a.so", "1", {}, "observer"), runOf("/a.so", "9", {}, "observer")).empty());
  const Json now = runOf("/a/cells.so", "1", {{"/a/x.py", "2"}});
  for (const char* foreign : {"null", "[]", "{\"plugins\": 3}", "{\"plugins\": [3, \"x\"]}",
                              "{\"plugins\": [{\"role\": [1]}]}"}) {
    CHECK(changed(Json::parse(foreign), now).empty());
  }
}
