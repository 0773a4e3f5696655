// SPDX-License-Identifier: BSD-3-Clause
// The images of a recorded run, read again by the run's own configuration while the data are there.
#pragma once

#include <memory>
#include <string>

#include "app/assembly.hpp"

namespace tolman::app {

class RecordedImages {
 public:
  /// Of the run in `directory`. Where its source cannot be made again there are no images, and
  /// problem() says why.
  RecordedImages(const std::filesystem::path& directory, std::vector<std::string> plugin_paths,
                 const Clock& clock, const Cancellation& cancellation);
  ~RecordedImages();

  /// Gives a recorded frame its images. Frames come in order. The first one that does not fit ends
  /// it for good.
  void restore(Frame& recorded);
  /// Why there are none any more; empty as long as there are.
  const std::string& problem() const { return problem_; }

 private:
  void end(const std::string& problem);

  RunLog log_{true};  ///< the source has said all that it had to say when the run was made
  std::unique_ptr<Assembly> assembly_;
  Frame next_;
  std::string problem_;
};

}  // namespace tolman::app
