// SPDX-License-Identifier: BSD-3-Clause
// Replaces the plugin `python` in a build without Python: it fails and names what is missing.
#include "tolman/plugin.hpp"

namespace {

tolman::Status refuseProgram(const std::string&, tolman::Program&) {
  return tolman::Status::unsupported(
      "this build of Tolman runs no Python; install pybind11-dev and python3-dev, and build again");
}

}  // namespace

TOLMAN_INTERPRETER(python, ".py", "0.1.0", "Plugins written in Python: not in this build.",
                   &refuseProgram);
