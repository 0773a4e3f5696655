// SPDX-License-Identifier: BSD-3-Clause
// Where the plugins that were made for tests are built.
#pragma once

#include <string>

#include "support/paths.hpp"

namespace tolman::test {

inline const std::string kFixturePlugins = inBuild("tests/fixtures/plugins/");

}  // namespace tolman::test
