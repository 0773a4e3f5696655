// SPDX-License-Identifier: BSD-3-Clause
#include "engine/recorded_images.hpp"

namespace tolman::run {

RecordedImages::RecordedImages(const std::filesystem::path& directory,
                               std::vector<std::string> plugin_paths, const Clock& clock,
                               const Cancellation& cancellation) {
  const std::filesystem::path config = directory / "config.resolved.yaml";
  try {
    auto checked = checkSystem({config.string(), {}, std::move(plugin_paths)}, Scope::Source);
    assembly_ = std::make_unique<Assembly>(require(std::move(checked)), log_, clock, cancellation);
  } catch (const Failed& failed) {
    end(failed.what());
  }
}

void RecordedImages::restore(Frame& recorded) {
  while (assembly_ && next_.frame < recorded.frame) {
    const Status status = assembly_->source().next(next_);
    if (status.code() == StatusCode::EndOfStream) return end("the source has fewer frames now");
    if (!status.isOk()) return end(status.message());
  }
  if (!assembly_) return;
  if (next_.frame != recorded.frame || next_.stamp_ns != recorded.stamp_ns) {
    return end("the data are not those of the run: frame " + std::to_string(recorded.frame) +
               " has another time");
  }
  recorded.left = next_.left;
  recorded.right = next_.right;
}

void RecordedImages::end(const std::string& problem) {
  problem_ = problem.substr(0, problem.find('\n'));
  assembly_.reset();
}

}  // namespace tolman::run
