// SPDX-License-Identifier: BSD-3-Clause
// Registration of the viewer.
#include "tolman/plugin.hpp"

#include "web_viewer.hpp"

TOLMAN_PLUGIN(web_viewer, tolman::web_viewer::WebViewer, "0.1.0",
              "Shows a run in a browser, live and back in time.");
