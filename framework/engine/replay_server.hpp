// SPDX-License-Identifier: BSD-3-Clause
// Replays a recorded run, frame by frame, to an observer that serves a page. A run that is still
// being recorded is followed to its end.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "engine/checked_system.hpp"
#include "engine/services.hpp"
#include "record/run_reader.hpp"

namespace tolman::engine {

/// The images of a recorded run, read again from the source that its configuration names.
class RecordedImages {
 public:
  /// Opens the source of the run in `directory`. If that fails, there are no images, and problem()
  /// says why.
  RecordedImages(const std::filesystem::path& directory, std::vector<std::string> plugin_paths,
                 const Clock& clock, const Cancellation& cancellation);

  /// Adds the images to a recorded frame. Frames must come in order. After the first frame that
  /// does not match the source no more images are added.
  void restore(Frame& recorded);
  /// The left images of recorded frames, as far as there are any.
  std::map<std::int64_t, Image> views(const record::RunReader& reader,
                                      const std::set<std::int64_t>& frames);
  /// Why there are no images; empty while there are images.
  const std::string& problem() const { return problem_; }

 private:
  void end(const std::string& problem);

  RunLog log_{true};  ///< warnings of the source were shown when the run was recorded
  std::unique_ptr<Assembly> assembly_;
  Frame next_;
  std::string problem_;
};

struct ReplayOptions {
  std::filesystem::path run;  ///< run directory
  int port = -1;              ///< -1: the plugin's own default
  std::string bind;           ///< empty: the plugin's own default
  bool images = true;         ///< read the images again from the source of the run
  std::vector<std::string> plugin_paths;
};

/// Callbacks on the thread of serve().
struct ReplayListener {
  std::function<void(const std::string& url)> serving;
  std::function<void(std::int64_t frames)> loading;  ///< number of frames in the record
  std::function<void()> frame;                       ///< one more is loaded
  std::function<void()> loaded;
  std::function<void(const std::string&)> note;  ///< for a person
};

class ReplayServer {
 public:
  ReplayServer(const ReplayOptions& options, RunLog& log, const Clock& clock,
               const Cancellation& cancellation, const ReplayListener& listener)
      : options_(options),
        clock_(clock),
        cancellation_(cancellation),
        listener_(listener),
        logger_(log, "viewer") {}

  /// Serves until it is cancelled. Throws Failure.
  void serve();

 private:
  /// Artefacts of a replay are discarded.
  class NoArtefacts : public ArtefactWriter {
   public:
    Status write(std::string_view, std::span<const std::byte>) override { return Status::ok(); }
  };

  void openObserver(bool running);
  ParameterValues parametersOf(const Schema& schema, bool running) const;
  void beginRun(const record::RunReader& reader, bool running);
  void follow();
  void showNewFrames(const record::RunReader& reader, bool running);
  void show(record::RecordedFrame& recorded, const MapGraph* graph);

  const ReplayOptions& options_;
  const Clock& clock_;
  const Cancellation& cancellation_;
  const ReplayListener& listener_;
  StageLogger logger_;
  Findings all_findings_;
  StageFindings findings_{all_findings_, "viewer"};
  NoArtefacts artefacts_;
  ParameterValues values_;
  std::unique_ptr<host::ObserverStage> observer_;
  std::unique_ptr<RecordedImages> images_;
  record::ReplayPosition position_;
  MapGraph graph_;
  bool image_problem_reported_ = false;
};

}  // namespace tolman::engine
