// SPDX-License-Identifier: BSD-3-Clause
// The services of a context as Python objects. They refer to those of the context, which must
// outlive them.
#pragma once

#include <pybind11/pybind11.h>

#include "tolman/context.hpp"

namespace tolman::python {

/// A dict with log, write_artefact, rig, seed and name.
pybind11::object servicesOf(const Context& context);
/// A dict from names to values.
pybind11::object valuesOf(const ParameterValues& values);

}  // namespace tolman::python
