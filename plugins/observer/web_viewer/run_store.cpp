// SPDX-License-Identifier: BSD-3-Clause
#include "run_store.hpp"

namespace tolman::web_viewer {
namespace {

constexpr JpegOptions kThumbnail = {320, 70};

}  // namespace

RunStore::RunStore(const JpegOptions& jpeg_options, std::uint64_t spool_bytes)
    : jpeg_options_(jpeg_options),
      frames_(spool_bytes - spool_bytes / 8),
      template_images_(spool_bytes / 8) {
  hello_.columns = rowColumns();
}

void RunStore::add(const PendingData& pending) {
  rows_.append(pending.rows);
  events_.append(pending.events);
  messages_.append(pending.messages);
  pose_ = pending.pose;
  if (pending.has_graph) {
    graph_ = std::make_shared<const std::string>(pending.graph.encode());
    flat_graph_ = pending.graph;
  }
  if (pending.has_frame) {
    const auto frame =
        std::make_shared<const EncodedFrame>(encodeFrame(pending.newest, jpeg_options_));
    (void)frames_.store(frame->header.frame, storedMessage(*frame, pending.events));
    newest_ = frame;
  }
  for (const TemplateImage& made : pending.template_images) {
    // Not stored when the spool is full: /api/template then answers 404.
    (void)template_images_.store(made.template_id, jpeg(made.image, kThumbnail));
  }
}

HelloHeader RunStore::hello() const {
  HelloHeader hello = hello_;
  hello.rows = static_cast<std::int64_t>(rows_.size());
  return hello;
}

void RunStore::end(std::string_view state) {
  end_state_ = state;
  hello_.live = false;
}

std::string RunStore::endMessage() const {
  const EndHeader header{end_state_, static_cast<std::int64_t>(rows_.size())};
  return encodeContainer(headerJson(header), {});
}

}  // namespace tolman::web_viewer
