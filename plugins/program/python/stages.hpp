// SPDX-License-Identifier: BSD-3-Clause
// The six roles, each passing its calls to an object of the program's class.
#pragma once

#include <string>

#include "tolman/plugin.hpp"

namespace tolman::python {

/// The descriptor of a role, with static storage. Throws std::out_of_range for an unknown role.
const PluginDescriptor* descriptorOf(const std::string& role);

}  // namespace tolman::python
