// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin.
#include "tolman/plugin.hpp"

#include "bayesian_attractor.hpp"

using tolman::bayesian_attractor::BayesianAttractor;

TOLMAN_PLUGIN(bayesian_attractor, BayesianAttractor, "0.1.0",
              "Head direction ring and grid torus as Bayesian attractor networks.");
