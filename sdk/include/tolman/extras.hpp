// SPDX-License-Identifier: BSD-3-Clause
// Small interfaces that a plugin may implement beside its role: its class derives from them as
// well, and the plugin macro detects that. New capabilities come as new extras, never as new
// virtual functions of a role, so that old plugins can still be loaded.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman {

/// Offers internal state as named arrays, to recorder and viewers. Called after each frame, under
/// the threading rules of the role (roles.hpp).
class ArraySource {
 public:
  virtual ~ArraySource() noexcept(false) {}  // as in Plugin: one class derives from both
  /// Appends arrays, at most 256. Names and shapes stay the same over a run. A name has 1 to 100
  /// bytes of UTF-8 without control characters, and no other array has it.
  virtual void arrays(std::vector<NamedArray>& arrays) const = 0;
};

/// Describes the arrays of ArraySource::arrays(), or of Frame::sensors for a source: units, axes,
/// periods. Called once, after configure(). Arrays without a description are shown as plain
/// numbers.
class ArrayDescriptions {
 public:
  virtual ~ArrayDescriptions() noexcept(false) {}
  virtual Status describe(std::vector<ArrayInfo>& arrays) const = 0;
};

/// A source whose images are not rectified. The host rectifies them: stages get the rectified
/// images and cameras. Called once, after info(), whose rig must have the size of the raw images
/// and be uncalibrated. Each frame has one image per camera.
class RawRigSource {
 public:
  virtual ~RawRigSource() noexcept(false) {}
  virtual Status rawRig(RawRig& rig) = 0;
};

/// A source of live images, such as those of a camera. It gives no image twice: after the first
/// image, reset() is Unsupported. `tolman plugins validate` skips the checks that need the same
/// images again.
class LiveSource {
 public:
  virtual ~LiveSource() noexcept(false) {}
};

/// An observer that serves a page over HTTP. `tolman run --view` and `tolman view` load the
/// observer that has this extra. `tolman view` sets these of its parameters, if it declares them:
/// `port` and `bind` from the command line, `rate` = 0 (every frame), `stay` = true (serve until
/// cancelled), and `recorded` (true if the run has ended).
class PageServer {
 public:
  virtual ~PageServer() noexcept(false) {}
  /// Address of the page, "http://127.0.0.1:8080/"; known from begin() on, empty before.
  virtual std::string url() const = 0;
};

/// Saves and restores the complete state. After load() of what save() wrote, the instance answers
/// further frames as the saved instance would have answered them. load() of foreign or damaged
/// bytes fails with InvalidInput and leaves the instance as after reset().
class StateKeeper {
 public:
  virtual ~StateKeeper() noexcept(false) {}
  virtual Status save(std::ostream& stream) const = 0;
  virtual Status load(std::istream& stream) = 0;
};

/// Place recognition or cells that can use a saved map without changing it (`tolman run
/// --localise`). Where Context::localise is true, load() comes before the first frame, and from
/// then on nothing is learned: place recognition never answers Novel, cells answer as Decision
/// says, and memory does not grow with time. A map needs no such extra: it is loaded and not
/// updated.
class Localiser : public StateKeeper {};

}  // namespace tolman
