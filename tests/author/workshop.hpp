// SPDX-License-Identifier: BSD-3-Clause
// The environment of a plugin author: Tolman below its own prefix, and a shell that finds it.
#pragma once

#include <filesystem>
#include <string>

#include "end_to_end/process.hpp"
#include "support/data.hpp"

namespace tolman::test {

class Workshop {
 public:
  /// Installs the build tree; throws when that fails.
  Workshop();

  /// Where the author works; empty at first.
  std::filesystem::path folder() const { return temporary_.path() / "work"; }
  std::filesystem::path prefix() const { return temporary_.path() / "prefix"; }

  /// Runs a script as bash -e in `folder()`, with `tolman` on the path and the SDK where CMake
  /// looks.
  Finished shell(const std::string& script) const { return shell(script, prefix()); }
  /// The same with what is installed below another prefix.
  Finished shell(const std::string& script, const std::filesystem::path& prefix) const;

 private:
  TemporaryFolder temporary_;
};

}  // namespace tolman::test
