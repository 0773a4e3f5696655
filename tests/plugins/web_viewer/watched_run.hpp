// SPDX-License-Identifier: BSD-3-Clause
// A viewer that observes a synthetic run whose values are known.
#pragma once

#include <memory>

#include "support/context.hpp"
#include "web_viewer.hpp"

namespace tolman::test {

/// A frame of the synthetic run: 1 m forward per frame, a new template at every tenth.
struct TestFrame {
  explicit TestFrame(std::int64_t index, bool with_image = true);
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

/// The graph after `index` frames: an experience at every tenth, linked in a chain. From three
/// experiences on there is also a loop link, which the map has rejected.
MapGraph graphAt(std::int64_t index);

class WatchedRun {
 public:
  explicit WatchedRun(ParameterValues values = {});
  /// Gives `count` more frames to the viewer.
  void frames(std::int64_t count, bool with_image = true);
  void finish();
  /// The same without an assertion, which only one thread may have at a time (Catch2).
  [[nodiscard]] Status end();
  int port() const;
  std::int64_t shown() const { return next_; }

  TestContext context;
  std::unique_ptr<web_viewer::WebViewer> viewer = std::make_unique<web_viewer::WebViewer>();

 private:
  std::int64_t next_ = 0;
};

/// The parameters, with port 0 unless they have a port.
ParameterValues withAnyPort(ParameterValues values);

}  // namespace tolman::test
