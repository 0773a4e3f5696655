// SPDX-License-Identifier: BSD-3-Clause
// The configuration that `tolman init` writes.
#pragma once

#include <filesystem>
#include <string>

#include "app/recording_search.hpp"

namespace tolman::app {

enum class CarriedBy : std::uint8_t { Unknown, Car, Hand, Toy };

/// A guess where the user does not say it: a wide baseline or a wide image means a car.
CarriedBy guessCarrier(const Probe& probe);

/// The file in configs/init with the stages for these images: hand_stereo.yaml
std::string stagesFile(const Probe& probe, CarriedBy carrier);

/// `told` is Unknown if the carrier is guessed; `stages` is the text of stagesFile().
std::string initText(const std::filesystem::path& recording, const RecordingSearch& search,
                     CarriedBy told, const std::string& stages);

}  // namespace tolman::app
