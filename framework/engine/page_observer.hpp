// SPDX-License-Identifier: BSD-3-Clause
// The observer that serves a page of the run, for `--view` and `tolman view`: any plugin whose
// manifest lists the extra `page` (class PageServer of the SDK).
#pragma once

#include <string>

#include "host/catalogue.hpp"

namespace tolman::run {

/// Id of the observer with the extra `page`: `wanted`, or when that is empty the first by id.
/// Refusals: plugin/not-found, plugin/no-page, and those of Catalogue::find().
host::OrRefusal<std::string> findPageObserver(const host::Catalogue& catalogue,
                                              const std::string& wanted = {});

}  // namespace tolman::run
