// SPDX-License-Identifier: BSD-3-Clause
#include "event_client.hpp"

#include <utility>

namespace tolman::web_viewer {

void EventClient::opened() {
  next_ = state().store.messages().end();
  sendNext();
}

void EventClient::sendNext() {
  if (!canSend()) return;
  const RunStore& store = state().store;
  if (auto message = store.messages().next(next_)) return send(std::move(message));
  if (store.pose().frame > sent_pose_) {
    sent_pose_ = store.pose().frame;
    return send(std::make_shared<const std::string>(poseMessage(store.pose())));
  }
  if (!store.hasEnded()) return;
  if (!std::exchange(end_sent_, true)) {
    return send(
        std::make_shared<const std::string>(endMessage(store.endState(), store.pose().frame)));
  }
  if (!state().keeps_open) close(boost::beast::websocket::close_code::normal);
}

}  // namespace tolman::web_viewer
