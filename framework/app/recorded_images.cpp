// SPDX-License-Identifier: BSD-3-Clause
#include "app/recorded_images.hpp"

namespace tolman::app {

RecordedImages::RecordedImages(const std::filesystem::path& directory,
                               std::vector<std::string> plugin_paths, const Clock& clock,
                               const Cancellation& cancellation) {
  const std::filesystem::path config = directory / "config.resolved.yaml";
  auto assembled = Assembly::open({config.string(), {}, std::move(plugin_paths)}, Scope::Source,
                                  log_, clock, cancellation);
  if (auto* failure = std::get_if<Failure>(&assembled)) {
    end(failure->message);
    return;
  }
  assembly_ = std::move(std::get<std::unique_ptr<Assembly>>(assembled));
}

RecordedImages::~RecordedImages() {
  if (assembly_) (void)assembly_->teardown();
}

void RecordedImages::restore(Frame& recorded) {
  while (assembly_ && next_.frame < recorded.frame) {
    const Status status = assembly_->source().next(next_);
    if (status.code() == StatusCode::EndOfStream) return end("the source has fewer frames now");
    if (!status.isOk()) return end(status.message());
  }
  if (!assembly_) return;
  if (next_.frame != recorded.frame || next_.stamp_ns != recorded.stamp_ns) {
    return end("the data are not those of the run, frame " + std::to_string(recorded.frame) +
               " has another time");
  }
  recorded.left = next_.left;
  recorded.right = next_.right;
}

void RecordedImages::end(const std::string& problem) {
  problem_ = problem.substr(0, problem.find('\n'));
  if (assembly_) (void)assembly_->teardown();
  assembly_.reset();
}

}  // namespace tolman::app
