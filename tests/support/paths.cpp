// SPDX-License-Identifier: BSD-3-Clause
#include "support/paths.hpp"

namespace tolman::test {

std::string inSource(const std::string& path) { return TOLMAN_SOURCE_DIR "/" + path; }

std::string inBuild(const std::string& path) { return TOLMAN_BINARY_DIR "/" + path; }

}  // namespace tolman::test
