// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/protocol.hpp"

#include <nlohmann/json.hpp>

namespace tolman::conformance {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckTask, check, report_descriptor, file, id, set, seed, level,
                                   scratch, timeout_s, memory_mib)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CallStarted, call)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurrentInput, description)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckFinding, severity, message, remedy)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, name, value, unit)
static void to_json(Json& json, const CheckCompleted&) { json = nullptr; }

namespace {

std::string dump(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// [index of the alternative, its value]
CheckMessage fromJson(const Json& json) {
  const Json& value = json.at(1);
  switch (json.at(0).get<std::size_t>()) {
    case 0:
      return value.get<CallStarted>();
    case 1:
      return value.get<CurrentInput>();
    case 2:
      return value.get<CheckFinding>();
    case 3:
      return value.get<Measurement>();
    case 4:
      return CheckCompleted{};
    default:
      throw std::runtime_error("no message");
  }
}

}  // namespace

std::string encode(const CheckTask& task) { return dump(task); }

CheckTask decodeTask(const std::string& text) { return Json::parse(text).get<CheckTask>(); }

std::string encode(const CheckMessage& message) {
  return dump(std::visit([&](const auto& m) { return Json{message.index(), m}; }, message));
}

std::optional<CheckMessage> decodeMessage(const std::string& line) {
  try {
    return fromJson(Json::parse(line));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace tolman::conformance
