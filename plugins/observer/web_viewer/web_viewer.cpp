// SPDX-License-Identifier: BSD-3-Clause
#include "web_viewer.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "viewer_thread.hpp"

namespace tolman::web_viewer {
namespace {

ViewerOptions optionsOf(const WebViewer::Parameters& p) {
  ViewerOptions options;
  options.address = {p.bind, p.port, p.port == WebViewer::Parameters().port};
  options.clients = static_cast<std::size_t>(p.clients);
  options.rate = p.rate;
  options.recorded = p.recorded;
  options.jpeg_options = {.width = p.image_width};
  options.spool_bytes = static_cast<std::uint64_t>(p.spool_mib) << 20U;
  return options;
}

/// Prints a line on the terminal over a possible progress line. A single write, so that the
/// progress line is drawn before or after it.
void printLine(const std::string& text) {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::string blanks(static_cast<std::size_t>(known ? size.ws_col - 1 : 79), ' ');
  std::cerr << "\r" + blanks + "\r" + text + "\n" << std::flush;
}

}  // namespace

WebViewer::WebViewer() = default;

/// If finish() was not called, the run has failed: clients get its end as "interrupted".
WebViewer::~WebViewer() {
  if (viewer_) viewer_->finish(nullptr, "interrupted", {});
}

Status WebViewer::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  artefacts_ = &context.artefacts;
  cancellation_ = &context.cancellation;
  prints_ = !parameters_.quiet && isatty(STDERR_FILENO) == 1;
  return reset();
}

Status WebViewer::reset() {
  if (viewer_) viewer_->finish(nullptr, "interrupted", {});
  viewer_.reset();  // frees the port for the new one
  std::unique_ptr<ViewerThread> viewer;
  try {
    viewer = std::make_unique<ViewerThread>(optionsOf(parameters_), *log_);
  } catch (const std::system_error& error) {  // of a temporary file
    return Status::failed(error.what());
  }
  const Status status = viewer->start();
  if (!status.isOk()) return status;
  viewer_ = std::move(viewer);
  if (viewer_->port() != parameters_.port && parameters_.port != 0) {
    log_->info("port " + std::to_string(parameters_.port) + " is in use, using port " +
               std::to_string(viewer_->port()));
  }
  if (!viewer_->isLoopback()) {
    log_->warning("the viewer listens on " + parameters_.bind +
                  ": everybody who reaches this machine can watch, there is no password");
  }
  return status;
}

std::string WebViewer::url() const { return viewer_ ? viewer_->url() : std::string(); }

Status WebViewer::begin(const RunInfo& run) {
  if (!viewer_) return Status::failed("the viewer has ended; call reset() before another run");
  viewer_->begin(run);
  announce();
  return Status::ok();
}

void WebViewer::announce() {
  log_->info("watch at " + viewer_->url());
  const nlohmann::json json = {{"url", viewer_->url()}, {"port", viewer_->port()}};
  const std::string text = json.dump(2) + "\n";
  const Status written = artefacts_->write("viewer.json", std::as_bytes(std::span(text)));
  if (!written.isOk()) log_->debug("viewer.json: " + written.message());
  if (prints_) printLine("watch at " + viewer_->url());
}

Status WebViewer::observe(const Snapshot& snapshot) {
  if (viewer_ && snapshot.frame != nullptr) viewer_->observe(snapshot);
  return Status::ok();
}

Status WebViewer::finish(const MapGraph& graph) {
  if (!viewer_) return Status::ok();
  const char* state = cancellation_->requested() ? "interrupted" : "finished";
  const bool stay = parameters_.stay && !parameters_.quiet;
  if (stay && prints_ && !cancellation_->requested()) {
    printLine("the run has ended; " + viewer_->url() + " is served until Ctrl-C");
  }
  viewer_->finish(&graph, state, [&] { return stay && !cancellation_->requested(); });
  viewer_.reset();
  return Status::ok();
}

}  // namespace tolman::web_viewer
