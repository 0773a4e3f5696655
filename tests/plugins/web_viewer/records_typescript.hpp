// SPDX-License-Identifier: BSD-3-Clause
// TypeScript declarations of the viewer's messages, generated from the records' field lists:
// interfaces of the message headers, names and units of the columns of a history row, and the names
// of enumerations. The page's src/wire/records.ts is this text. It has no documentation, so that a
// changed sentence in the SDK does not change the page.
#pragma once

#include <string>

namespace tolman::web_viewer {

std::string recordsTypeScript();

}  // namespace tolman::web_viewer
