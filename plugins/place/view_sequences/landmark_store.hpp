// SPDX-License-Identifier: BSD-3-Clause
// Landmarks of stored views, in a file without a name that is removed with the plugin. Only their
// offsets are in memory, and only those of candidates are read.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "edge_patches.hpp"
#include "landmarks.hpp"
#include "scratch_file.hpp"
#include "tolman/state_stream.hpp"
#include "tolman/status.hpp"

namespace tolman::view_sequences {

/// Landmarks with the edges around them, one patch for each.
struct StoredLandmarks {
  landmarks::Landmarks corners;
  std::vector<landmarks::EdgePatch> patches;
};

class LandmarkStore {
 public:
  /// `view` must be larger than that of all earlier calls.
  Status add(std::int64_t view, const StoredLandmarks& landmarks);
  /// The view with landmarks nearest to `view`, at most `reach` views away; at equal distance the
  /// older one.
  std::optional<std::int64_t> nearest(std::int64_t view, std::int64_t reach) const;
  /// The landmarks of a view that has some.
  Result<StoredLandmarks> read(std::int64_t view) const;

  /// Fails if the file cannot be read.
  Status save(StateWriter& writer) const;
  /// InvalidInput for damaged bytes.
  Status load(StateReader& reader, std::int64_t views);

 private:
  struct StoredView {
    std::int64_t view;
    std::int64_t offset;  ///< in the file
    std::int64_t count;   ///< of landmarks
  };

  Status append(std::int64_t view, std::int64_t count, const std::vector<std::uint8_t>& bytes);
  Result<std::vector<std::uint8_t>> bytesOf(const StoredView& entry) const;

  std::vector<StoredView> entries_;
  std::int64_t end_ = 0;
  ScratchFile file_;
};

}  // namespace tolman::view_sequences
