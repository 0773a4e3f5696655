// SPDX-License-Identifier: BSD-3-Clause
// The table of conformance checks: each is one requirement on a plugin and the function that tests
// it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::conformance {

class CheckContext;

/// Roles as a bit mask.
constexpr unsigned bit(Role role) { return 1U << static_cast<unsigned>(role); }
inline constexpr unsigned kAllRoles = 0x3f;
inline constexpr unsigned kSource = bit(Role::Source);
inline constexpr unsigned kWithInput = kAllRoles & ~kSource;
inline constexpr unsigned kWithImages =
    bit(Role::Odometry) | bit(Role::Place) | bit(Role::Observer);

struct Check {
  std::string_view id;
  int level;       ///< lowest level that includes it: 1 contract, 2 reproducible results, 3 all
  unsigned roles;  ///< roles that it applies to, as bit()
  std::string_view demand;
  std::string_view remedy;  ///< for findings that give no remedy
  void (*run)(CheckContext&);
  bool same_images = false;  ///< needs the same images several times: not from a LiveSource
};

// The checks by topic.
std::span<const Check> declarationChecks();
std::span<const Check> lifeChecks();
std::span<const Check> inputChecks();
std::span<const Check> parameterChecks();
std::span<const Check> repeatChecks();
std::span<const Check> stateChecks();
std::span<const Check> processChecks();
std::span<const Check> costChecks();

/// All checks in the order in which they run.
std::vector<Check> allChecks();

}  // namespace tolman::conformance
