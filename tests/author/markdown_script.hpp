// SPDX-License-Identifier: BSD-3-Clause
// The instructions of a page as a script that runs its commands and writes its files.
#pragma once

#include <string>

namespace tolman::test {

/// The page's blocks in their order:
/// - "```sh" blocks are commands;
/// - any other block whose last line of text before it ends in "`file`:" is written to that file.
/// All other blocks and all text are left out. Each command is echoed to stderr before it runs.
std::string scriptOf(const std::string& page);

}  // namespace tolman::test
