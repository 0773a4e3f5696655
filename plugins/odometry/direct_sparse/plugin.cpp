// SPDX-License-Identifier: BSD-3-Clause
// Registers direct_sparse_stereo and direct_sparse_mono.
#include "tolman/plugin.hpp"

#include "direct_sparse.hpp"

namespace tolman::direct_sparse {

class DirectSparseStereo final : public DirectSparse {
 public:
  using Parameters = direct_sparse::Parameters;
  DirectSparseStereo() : DirectSparse(Cameras::Stereo) {}
};

class DirectSparseMono final : public DirectSparse {
 public:
  using Parameters = MonoParameters;
  DirectSparseMono() : DirectSparse(Cameras::Single) {}
};

}  // namespace tolman::direct_sparse

using tolman::direct_sparse::DirectSparseMono;
using tolman::direct_sparse::DirectSparseStereo;

TOLMAN_PLUGIN(direct_sparse_stereo, DirectSparseStereo, "0.1.0",
              "Direct sparse stereo odometry: windowed photometric bundle adjustment.");

TOLMAN_PLUGIN(direct_sparse_mono, DirectSparseMono, "0.1.0",
              "Direct sparse odometry of a single camera; lengths in arbitrary units.");
