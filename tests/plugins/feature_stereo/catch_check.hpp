// SPDX-License-Identifier: BSD-3-Clause
// Ceres includes glog, whose CHECK ends the program, and replaces Catch's. This gives it back; to
// be included after the plugin's headers.
#pragma once

#include <catch2/catch.hpp>

#undef CHECK
#define CHECK(...) \
  INTERNAL_CATCH_TEST("CHECK", Catch::ResultDisposition::ContinueOnFailure, __VA_ARGS__)
