// SPDX-License-Identifier: BSD-3-Clause
// The six roles, each passing its calls to an object of the program's class.
#pragma once

#include <string>

#include "tolman/program.hpp"

namespace tolman::python {

/// With static storage. Throws std::out_of_range for no role.
const PluginDescriptor* descriptorOf(const std::string& role);

}  // namespace tolman::python
