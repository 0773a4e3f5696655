// SPDX-License-Identifier: BSD-3-Clause
#include "host/opened_files.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/data.hpp"

using namespace tolman;
using namespace tolman::isolation;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE("a plugin's library, program and other files are compared") {
  const tolman::test::TemporaryFolder folder;
  host::Manifest manifest;
  manifest.file = folder.path() / "plugin.so";
  manifest.program = folder.path() / "cells.py";
  manifest.program_files = {(folder.path() / "helper.py").string()};
  for (const char* name : {"plugin.so", "cells.py", "helper.py"}) write(folder.path() / name, "1");
  const auto before = openedFiles(manifest);
  CHECK(before.size() == 3);
  CHECK_FALSE(changedFile(before, openedFiles(manifest)));

  for (const char* name : {"plugin.so", "cells.py", "helper.py"}) {
    const auto now = openedFiles(manifest);
    write(folder.path() / "new", "1");  // the same size
    fs::rename(folder.path() / "new", folder.path() / name);
    CHECK(changedFile(now, openedFiles(manifest)) == folder.path() / name);
  }
  const auto now = openedFiles(manifest);
  write(folder.path() / "helper.py", "12");
  CHECK(changedFile(now, openedFiles(manifest)) == folder.path() / "helper.py");
  fs::remove(folder.path() / "helper.py");
  CHECK(changedFile(now, openedFiles(manifest)) == folder.path() / "helper.py");
}

TEST_CASE("a file that only one process opened is a change") {
  const tolman::test::TemporaryFolder folder;
  host::Manifest manifest;
  manifest.file = folder.path() / "plugin.so";
  write(manifest.file, "1");
  const auto before = openedFiles(manifest);
  manifest.program_files = {(folder.path() / "more.so").string()};
  CHECK(changedFile(before, openedFiles(manifest)) == folder.path() / "more.so");
  CHECK(changedFile(openedFiles(manifest), before) == folder.path() / "more.so");
}
