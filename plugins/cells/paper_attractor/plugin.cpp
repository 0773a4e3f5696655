// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin.
#include "tolman/plugin.hpp"

#include "paper_attractor.hpp"

using tolman::paper_attractor::PaperAttractor;

TOLMAN_PLUGIN(paper_attractor, PaperAttractor, "0.1.0",
              "The Bayesian attractor network by its printed equations (arXiv:2003.03091).");
