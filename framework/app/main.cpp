// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

namespace tolman::app {
int runProgram(const std::vector<std::string>& command_line);  // program.hpp takes long to compile
}

int main(int argc, char** argv) { return tolman::app::runProgram({argv, argv + argc}); }
