// SPDX-License-Identifier: BSD-3-Clause
// Registration of the source that replays a recorded run.
#include "tolman/plugin.hpp"

#include "record_source.hpp"

TOLMAN_PLUGIN(record, tolman::record_source::RecordSource, "0.1.0",
              "The frames of a run that was made with record.replay, without images.");
