// SPDX-License-Identifier: BSD-3-Clause
// Where the checkout and its build lie. Only paths.cpp is compiled with these paths: a compiler
// cache finds every other test of another checkout.
#pragma once

#include <string>

namespace tolman::test {

std::string inSource(const std::string& path);  ///< "docs/embed.md" in the checkout
std::string inBuild(const std::string& path);   ///< "bin/tolman" in the build tree

}  // namespace tolman::test
