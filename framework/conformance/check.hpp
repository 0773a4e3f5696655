// SPDX-License-Identifier: BSD-3-Clause
// One thing that the kit asks of a plugin.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::conformance {

class Lab;

/// A set of roles.
constexpr unsigned bit(Role role) { return 1U << static_cast<unsigned>(role); }
inline constexpr unsigned kAllRoles = 0x3f;
inline constexpr unsigned kSource = bit(Role::Source);
inline constexpr unsigned kFed = kAllRoles & ~kSource;  ///< those that are given something
inline constexpr unsigned kSeeing = bit(Role::Odometry) | bit(Role::Place) | bit(Role::Observer);

struct Check {
  std::string_view id;
  int level;       ///< from which level on it is made: 1 must, 2 results, 3 everything
  unsigned roles;  ///< whom it is about
  std::string_view demand;
  std::string_view remedy;
  void (*run)(Lab&);
};

// By topic.
std::span<const Check> declarationChecks();
std::span<const Check> lifeChecks();
std::span<const Check> inputChecks();
std::span<const Check> parameterChecks();
std::span<const Check> repeatChecks();
std::span<const Check> stateChecks();
std::span<const Check> processChecks();
std::span<const Check> costChecks();

/// All, in the order in which they are made.
std::vector<Check> allChecks();

}  // namespace tolman::conformance
