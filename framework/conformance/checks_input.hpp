// SPDX-License-Identifier: BSD-3-Clause
// Faults of real data, applied to a generated input sequence.
#pragma once

#include "conformance/input_sequence.hpp"

namespace tolman::conformance {

// Legal: a plugin must answer.

/// Some frames without images and with `defect`; the last two among them.
void removeImages(InputSequence& sequence);
/// Some frames with lost tracking, some with the default records of skipped stages.
void loseTracking(InputSequence& sequence);
/// The first two frames with the default records of skipped stages.
void loseFirstFrames(InputSequence& sequence);
/// Some frames left out, as under `realtime`.
void dropFrames(InputSequence& sequence);
/// The same pixels with a stride larger than the width.
void padRows(InputSequence& sequence);
/// All images alternately black and white.
void makeTextureless(InputSequence& sequence);

// Illegal: a plugin may refuse each frame, but must not crash.

/// No right images although the rig is a stereo rig.
void removeRightImages(InputSequence& sequence);
/// Images of another size than the rig's.
void resizeImages(InputSequence& sequence);
/// Stamps that repeat and decrease.
void reverseStamps(InputSequence& sequence);

}  // namespace tolman::conformance
