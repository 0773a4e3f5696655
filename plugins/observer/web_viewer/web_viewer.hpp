// SPDX-License-Identifier: BSD-3-Clause
// Observer `web_viewer`: the run in a browser.
#pragma once

#include <memory>
#include <string>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

class ViewerThread;

class WebViewer final : public Observer {
 public:
  struct Parameters {
    int port = 8080;
    std::string bind = "127.0.0.1";
    int clients = 8;
    double rate = 10;
    int image_width = 640;
    int jpeg_quality = 70;
    int spool_mib = 512;
    bool stay = false;

    static constexpr auto declaration() {
      return parameters(
          parameter("port", &Parameters::port)
              .range(0, 65535)
              .doc("TCP port of the page; 0 for any free one. Where the default is taken, a free "
                   "one is used."),
          parameter("bind", &Parameters::bind)
              .doc("Address to listen on: 127.0.0.1 for this machine alone, 0.0.0.0 for all "
                   "networks. There is no password."),
          parameter("clients", &Parameters::clients)
              .range(1, 64)
              .doc("Most pages that watch at once."),
          parameter("rate", &Parameters::rate)
              .range(0, 1000)
              .unit("1/s")
              .doc("Frames a second that are shown and kept, by wall time; 0 for every frame, for "
                   "which the run waits. The graphs have all frames always."),
          parameter("image_width", &Parameters::image_width)
              .range(16, 4096)
              .unit("px")
              .doc("Wider images are made smaller, by a whole factor."),
          parameter("jpeg_quality", &Parameters::jpeg_quality)
              .range(1, 100)
              .doc("Quality of the images."),
          parameter("spool_mib", &Parameters::spool_mib)
              .range(1, 65536)
              .unit("MiB")
              .doc("Room on disk, in a temporary file, for frames to scrub back to; when it is "
                   "full, every second one is dropped."),
          parameter("stay", &Parameters::stay)
              .doc(
                  "Go on serving after the last frame, until Ctrl-C; not with --quiet, when nobody "
                  "would be told that the run waits."));
    }
  };

  WebViewer();
  ~WebViewer() override;
  WebViewer(const WebViewer&) = delete;
  WebViewer& operator=(const WebViewer&) = delete;

  Status configure(const Context& context) override;
  Status reset() override;
  Status begin(const RunInfo& run) override;
  Status observe(const Snapshot& snapshot) override;
  Status finish(const MapGraph& graph) override;

 private:
  void announce();

  Parameters parameters_;
  Logger* log_ = nullptr;
  ArtefactWriter* artefacts_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  bool interactive_ = false;
  bool quiet_ = false;
  std::unique_ptr<ViewerThread> viewer_;
};

}  // namespace tolman::web_viewer
