// SPDX-License-Identifier: BSD-3-Clause
// Shows a recorded run to the viewer plugin as if it were running; follows one that is.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/assembly.hpp"
#include "app/recorded_images.hpp"
#include "record/replay.hpp"

namespace tolman::app {

/// The observer that `tolman view` and `tolman run --view` load, like any other, by its id.
inline constexpr const char* kViewer = "web_viewer";

struct ViewOptions {
  std::filesystem::path run;
  int port = -1;     ///< -1: the plugin's own default
  std::string bind;  ///< empty: the plugin's own default
  bool images = true;
  std::vector<std::string> plugin_paths;
};

/// Where the viewer plugin serves: it writes so to its artefact viewer.json.
class ViewerAddress : public ArtefactWriter {
 public:
  using Tell = std::function<void(const std::string& viewer_json)>;
  explicit ViewerAddress(Tell tell) : tell_(std::move(tell)) {}
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  Tell tell_;
};

/// Hears what a view has to say.
struct ViewListener {
  ViewerAddress::Tell address;
  std::function<void(std::int64_t frames)> loading;  ///< so many there are to load
  std::function<void()> frame;                       ///< one more is loaded
  std::function<void()> loaded;
  std::function<void(const std::string&)> note;
};

class View {
 public:
  View(const ViewOptions& options, const Clock& clock, const Cancellation& cancellation,
       const ViewListener& listener);

  /// Until it is cancelled. Nothing when all went well.
  std::optional<Failure> serve();

 private:
  std::optional<Failure> openObserver();
  ParameterValues parametersOf(const Schema& schema) const;
  std::optional<Failure> beginRun(const record::RunReader& reader, bool running);
  std::optional<Failure> follow();
  std::optional<Failure> showNews(const record::RunReader& reader, bool running);
  Status show(record::RecordedFrame& recorded, const MapGraph* graph);

  const ViewOptions& options_;
  const Clock& clock_;
  const Cancellation& cancellation_;
  const ViewListener& listener_;
  RunLog log_;
  StageLogger logger_;
  ViewerAddress address_;
  ParameterValues values_;
  std::unique_ptr<plugins::ObserverStage> observer_;
  std::unique_ptr<RecordedImages> images_;
  record::ReplayPosition position_;
  MapGraph graph_;
  bool image_problem_told_ = false;
};

}  // namespace tolman::app
