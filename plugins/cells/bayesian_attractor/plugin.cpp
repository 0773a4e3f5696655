// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin.
#include "tolman/plugin.hpp"

#include "bayesian_attractor.hpp"

using tolman::bayesian_attractor::BayesianAttractor;

TOLMAN_PLUGIN(bayesian_attractor, BayesianAttractor, "0.2.0",
              "Competing bumps of head direction and grid cells that decide loops.");
