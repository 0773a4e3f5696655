// SPDX-License-Identifier: BSD-3-Clause
// A viewer and a made-up run before it, every number of which the tests can say.
#pragma once

#include <memory>

#include "support/context.hpp"
#include "web_viewer.hpp"

namespace tolman::test {

/// What one frame of the made-up run holds: a metre forward a frame, a new view each tenth.
struct Moment {
  explicit Moment(std::int64_t index, bool with_image = true);
  Snapshot snapshot() const;

  Frame frame;
  Motion motion;
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  std::vector<RunEvent> events;
  MapGraph graph;
  bool graph_changed = false;
};

/// The graph after `index` frames: an experience each tenth, a loop at the end.
MapGraph graphAt(std::int64_t index);

class Drive {
 public:
  explicit Drive(ParameterValues values = {});
  /// Shows `count` more frames.
  void frames(std::int64_t count, bool with_image = true);
  void finish();
  int port() const;
  std::int64_t shown() const { return next_; }

  TestContext context;
  std::unique_ptr<web_viewer::WebViewer> viewer = std::make_unique<web_viewer::WebViewer>();

 private:
  std::int64_t next_ = 0;
};

/// The host's parameters, with port 0 unless said otherwise.
ParameterValues withAnyPort(ParameterValues values);

}  // namespace tolman::test
