// SPDX-License-Identifier: BSD-3-Clause
// The reference page of run.sqlite, generated from the same declarations as its tables.
#pragma once

#include <string>

namespace tolman::record {

/// Markdown: every table, column, type, unit and meaning.
std::string recordsMarkdown();

}  // namespace tolman::record
