// SPDX-License-Identifier: BSD-3-Clause
#include "interpreter.hpp"

TOLMAN_INTERPRETER(python, ".py", "0.1.0",
                   "Plugins written in Python: {plugin: python, file: my_cells.py}.",
                   &tolman::python::openProgram);
