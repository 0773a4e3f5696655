// SPDX-License-Identifier: BSD-3-Clause
// Paths of the checkout and its build. Only paths.cpp is compiled with these paths, so that a
// compiler cache can share all other tests between checkouts.
#pragma once

#include <string>

namespace tolman::test {

std::string inSource(const std::string& path);  ///< "docs/embed.md" in the checkout
std::string inBuild(const std::string& path);   ///< "bin/tolman" in the build tree

}  // namespace tolman::test
