// SPDX-License-Identifier: BSD-3-Clause
// CPython in this process, and the program that it runs.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <string>

#include "tolman/context.hpp"
#include "tolman/plugin.hpp"

namespace tolman::python {

/// Opens the program; of type OpenProgram.
Status openProgram(const std::string& file, Program& program);

/// The open program.
struct OpenedProgram {
  pybind11::object host;  ///< the module tolman._host
  pybind11::object type;  ///< the class of the plugin
  bool has_arrays = false;
  bool has_descriptions = false;
};
/// The program of this process. To be called only after openProgram().
const OpenedProgram& opened();

/// Runs `work` with Python's lock. An exception becomes a failure of `call`, and its traceback is
/// written to `log` if there is one. Ends a copy of the process that the program made by fork().
Status inPython(const char* call, Logger* log, const std::function<void()>& work);

}  // namespace tolman::python
