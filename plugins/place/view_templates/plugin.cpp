// SPDX-License-Identifier: BSD-3-Clause
// Registers the plugin `view_templates`.
#include "tolman/plugin.hpp"

#include "view_templates.hpp"

using tolman::view_templates::ViewTemplates;

TOLMAN_PLUGIN(view_templates, ViewTemplates, "0.1.0",
              "Local view cells: small grey templates, matched over horizontal shifts.");
