// SPDX-License-Identifier: BSD-3-Clause
// Whether the true poses of several sessions are in one world frame: most sources give them from
// the first frame of each session.
#pragma once

#include <string>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the estimate agrees with the truth within each session, but not over all of them:
/// the root mean square error after one alignment is over five times that after an alignment of
/// each session on its own, and more than a fiftieth of the extent of the truth. Either the true
/// poses are in several world frames, or the map joins the sessions wrongly; the errors are the
/// same. Empty for poses of one session. Without an alignment, rigid ones are compared.
std::string sessionFramesHint(const Matches& matches, Alignment alignment);

}  // namespace tolman::evaluation
