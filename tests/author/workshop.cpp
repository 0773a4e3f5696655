// SPDX-License-Identifier: BSD-3-Clause
#include "author/workshop.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "support/paths.hpp"

namespace tolman::test {

Workshop::Workshop() {
  std::filesystem::create_directories(folder());
  const Finished installed =
      run({TOLMAN_CMAKE, "--install", inBuild(""), "--prefix", prefix().string()});
  if (installed.exit_code != 0) throw std::runtime_error(installed.out + installed.err);
}

Finished Workshop::shell(const std::string& script, const std::filesystem::path& prefix) const {
  const char* const path = std::getenv("PATH");
  std::vector<std::string> command = {
      "env",
      "-C",
      folder().string(),
      "PATH=" + (prefix / "bin").string() + ":" + (path != nullptr ? path : ""),
      "CMAKE_PREFIX_PATH=" + prefix.string(),
      "CMAKE_GENERATOR=Ninja"};
  if (std::string_view(TOLMAN_CCACHE) == "1") {
    command.insert(command.end(), {"CMAKE_CXX_COMPILER_LAUNCHER=ccache",
                                   "CCACHE_BASEDIR=" + temporary_.path().string()});
  }
  command.insert(command.end(), {"bash", "-euo", "pipefail", "-c", script});
  return run(command);
}

}  // namespace tolman::test
