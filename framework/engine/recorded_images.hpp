// SPDX-License-Identifier: BSD-3-Clause
// The images of a recorded run, read again from the source that its configuration names.
#pragma once

#include <memory>
#include <string>

#include "engine/assembly.hpp"

namespace tolman::run {

class RecordedImages {
 public:
  /// Opens the source of the run in `directory`. If that fails, there are no images, and problem()
  /// says why.
  RecordedImages(const std::filesystem::path& directory, std::vector<std::string> plugin_paths,
                 const Clock& clock, const Cancellation& cancellation);

  /// Adds the images to a recorded frame. Frames must come in order. After the first frame that
  /// does not match the source no more images are added.
  void restore(Frame& recorded);
  /// Why there are no images; empty while there are images.
  const std::string& problem() const { return problem_; }

 private:
  void end(const std::string& problem);

  RunLog log_{true};  ///< warnings of the source were shown when the run was recorded
  std::unique_ptr<Assembly> assembly_;
  Frame next_;
  std::string problem_;
};

}  // namespace tolman::run
