// SPDX-License-Identifier: BSD-3-Clause
// Registers direct_sparse_stereo.
#include "tolman/plugin.hpp"

#include "direct_sparse.hpp"

namespace tolman::direct_sparse {

class DirectSparseStereo final : public DirectSparse {
 public:
  using Parameters = direct_sparse::Parameters;
};

}  // namespace tolman::direct_sparse

using tolman::direct_sparse::DirectSparseStereo;

TOLMAN_PLUGIN(direct_sparse_stereo, DirectSparseStereo, "0.1.0",
              "Direct sparse stereo odometry: windowed photometric bundle adjustment.");
