// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin.
#include "tolman/plugin.hpp"

#include "view_sequences.hpp"

using tolman::view_sequences::ViewSequences;

TOLMAN_PLUGIN(view_sequences, ViewSequences, "0.1.0",
              "Sequences of views: dissimilarity to each place, added up along the driven path.");
