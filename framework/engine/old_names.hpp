// SPDX-License-Identifier: BSD-3-Clause
// The namespaces of the engine before its rooms were joined, for code outside of it.
#pragma once

namespace tolman::engine {}
namespace tolman {
namespace run = engine;
namespace pipeline = engine;
namespace imaging = engine;
}  // namespace tolman
