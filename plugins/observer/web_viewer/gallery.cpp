// SPDX-License-Identifier: BSD-3-Clause
#include "gallery.hpp"

namespace tolman::web_viewer {
namespace {

constexpr Picture kThumbnail = {320, 70};
constexpr std::size_t kShownStages = 5;  // all but the observers

nlohmann::json cameraJson(const CameraRig& rig) {
  if (rig.width == 0) return nullptr;
  return {{"width", rig.width},      {"height", rig.height}, {"fx", rig.pinhole.fx},
          {"fy", rig.pinhole.fy},    {"cx", rig.pinhole.cx}, {"cy", rig.pinhole.cy},
          {"baseline", rig.baseline}};
}

nlohmann::json runJson(const RunInfo& run) {
  nlohmann::json columns = nlohmann::json::array();
  for (const RowColumn& column : kRowColumns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  }
  const std::vector<std::string_view> stages(kRoleNames.begin(), kRoleNames.begin() + kShownStages);
  return {{"name", run.name},
          {"directory", run.directory},
          {"description", run.source.description},
          {"frames", run.source.frames},
          {"has_truth", run.source.has_truth},
          {"live", true},
          {"camera", cameraJson(run.source.rig)},
          {"stages", stages},
          {"row", columns},
          {"version", "0.1.0"}};
}

}  // namespace

Gallery::Gallery(const Picture& picture, std::uint64_t spool_bytes)
    : picture_(picture),
      run_(runJson({})),
      frames_(spool_bytes - spool_bytes / 8),
      views_(spool_bytes / 8) {}

void Gallery::begin(const RunInfo& run) { run_ = runJson(run); }

void Gallery::take(const Delivery& delivery) {
  rows_.append(delivery.rows);
  events_.append(delivery.events);
  if (delivery.has_graph) graph_ = std::make_shared<const std::string>(delivery.graph.encode());
  if (delivery.has_frame) {
    Exhibit exhibit{encodeFrame(delivery.newest, picture_), false};
    exhibit.stored =
        frames_.store(exhibit.encoded.frame, storedMessage(exhibit.encoded, delivery.events));
    newest_ = std::make_shared<const Exhibit>(std::move(exhibit));
  }
  for (const TemplateView& view : delivery.views) {
    (void)views_.store(view.template_id, jpeg(view.image, kThumbnail));  // full: 404 for this one
  }
}

void Gallery::end(std::string_view state) {
  end_state_ = state;
  run_["live"] = false;
}

std::string Gallery::endMessage() const {
  return encodeContainer({{"type", "end"}, {"state", end_state_}, {"frames", rows_.size()}}, {});
}

}  // namespace tolman::web_viewer
