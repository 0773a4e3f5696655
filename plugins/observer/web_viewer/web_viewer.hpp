// SPDX-License-Identifier: BSD-3-Clause
// Observer `web_viewer`: serves a page on which a run can be watched in a browser.
#pragma once

#include <memory>
#include <string>

#include "tolman/extras.hpp"
#include "tolman/roles.hpp"

namespace tolman::web_viewer {

class ViewerThread;

class WebViewer final : public Observer, public PageServer {
 public:
  struct Parameters {
    int port = 8080;
    std::string bind = "127.0.0.1";
    int clients = 8;
    double rate = 10;
    int image_width = 640;
    int spool_mib = 512;
    bool stay = false;
    bool recorded = false;
    bool quiet = false;

    static constexpr auto declaration() {
      return parameters(
          parameter("port", &Parameters::port)
              .range(0, 65535)
              .doc("TCP port of the page; 0 for any free port. When the default is in use, a free "
                   "port is used instead."),
          parameter("bind", &Parameters::bind)
              .doc("IP address to listen on: 127.0.0.1 for this machine alone, 0.0.0.0 for all "
                   "networks. There is no password."),
          parameter("clients", &Parameters::clients)
              .range(1, 64)
              .doc("Maximum number of pages that are connected at the same time."),
          parameter("rate", &Parameters::rate)
              .range(0, 1000)
              .unit("1/s")
              .doc("Frames per second of wall time whose images and arrays are shown and stored. 0 "
                   "for every frame; the run then waits for the viewer. Numbers of all frames are "
                   "always sent."),
          parameter("image_width", &Parameters::image_width)
              .range(16, 4096)
              .unit("px")
              .doc("Wider images are reduced by an integer factor."),
          parameter("spool_mib", &Parameters::spool_mib)
              .range(1, 65536)
              .unit("MiB")
              .doc("Size of the temporary file that holds past frames. When it is full, every "
                   "second stored frame is dropped."),
          parameter("stay", &Parameters::stay)
              .doc("Serve on after the last frame, until Ctrl-C. Ignored with `quiet`, since "
                   "nothing would show that the run waits."),
          parameter("recorded", &Parameters::recorded)
              .doc("The run has ended: the page does not call it live while its record is read. "
                   "Set by `tolman view`."),
          parameter("quiet", &Parameters::quiet)
              .doc("Print nothing on the terminal; set by --quiet. The log has the address."));
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
  std::string url() const override;

 private:
  void announce();

  Parameters parameters_;
  Logger* log_ = nullptr;
  ArtefactWriter* artefacts_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  bool prints_ = false;  ///< stderr is a terminal, and output is not disabled
  std::unique_ptr<ViewerThread> viewer_;
};

}  // namespace tolman::web_viewer
