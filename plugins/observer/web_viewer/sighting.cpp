// SPDX-License-Identifier: BSD-3-Clause
#include "sighting.hpp"

namespace tolman::web_viewer {
namespace {

template <class T>
bool copy(const T* from, T& to) {
  if (from != nullptr) to = *from;
  return from != nullptr;
}

/// All but the revisions, of which there may be many.
bool copyMotion(const Motion* from, Motion& to) {
  if (from == nullptr) return false;
  to.frame = from->frame;
  to.state = from->state;
  to.v = from->v;
  to.omega = from->omega;
  to.tracked = from->tracked;
  to.is_keyframe = from->is_keyframe;
  to.points_frame = from->points_frame;
  to.points = from->points;
  return true;
}

}  // namespace

void Sighting::take(const Snapshot& snapshot) {
  frame = snapshot.frame->frame;
  stamp_ns = snapshot.frame->stamp_ns;
  left = snapshot.frame->left;
  has_motion = copyMotion(snapshot.motion, motion);
  has_place = copy(snapshot.place, place);
  has_decision = copy(snapshot.decision, decision);
  has_map = copy(snapshot.map, map);
  if (!copy(snapshot.cells, cells)) cells.clear();
  times_ns = snapshot.stage_times_ns;
}

}  // namespace tolman::web_viewer
