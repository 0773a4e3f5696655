// SPDX-License-Identifier: BSD-3-Clause
// CPython in this process, and the program that it runs.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <string>

#include "tolman/context.hpp"
#include "tolman/program.hpp"

namespace tolman::python {

/// Opens the program; an OpenProgram.
Status openProgram(const std::string& file, Program& program);

/// What is known of the open program.
struct OpenedProgram {
  pybind11::object host;  ///< the module tolman._host
  pybind11::object type;  ///< the class of the plugin
  bool has_arrays = false;
  bool has_descriptions = false;
};
/// The one of this process. Only after openProgram().
const OpenedProgram& opened();

/// Runs `work` with Python's lock. What it raises becomes a failure of `call`, and its traceback an
/// entry of `log` if there is one. Ends a copy of the process that the program made by fork().
Status inPython(const char* call, Logger* log, const std::function<void()>& work);

}  // namespace tolman::python
