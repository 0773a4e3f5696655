// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/protocol.hpp"

#include <nlohmann/json.hpp>

#include "base/bounded_json.hpp"
#include "config/json_text.hpp"

namespace tolman::conformance {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckTask, check, report_descriptor, file, id, set, seed, level,
                                   scratch, timeout_s, memory_mib, program)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CallStarted, call)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurrentInput, description)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, name, value, unit)
static void to_json(Json& json, const CheckFinding& finding) {
  json = {{"severity", finding.severity}, {"message", finding.message}, {"remedy", finding.remedy}};
}
static void from_json(const Json& json, CheckFinding& finding) {
  const auto severity = config::integerFrom<std::uint8_t>(json.at("severity"));
  if (severity >= kCheckSeverityNames.size()) throw std::runtime_error("no severity");
  finding.severity = static_cast<CheckSeverity>(severity);
  json.at("message").get_to(finding.message);
  json.at("remedy").get_to(finding.remedy);
}
static void to_json(Json& json, const CheckCompleted&) { json = nullptr; }
static void from_json(const Json&, CheckCompleted&) {}

namespace {

std::string dump(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// Decodes a message from [index of the alternative, its value].
template <class... M>
void read(const Json& json, std::variant<M...>& message) {
  const auto index = config::integerFrom<std::size_t>(json.at(0));
  std::size_t i = 0;
  ((index == i++ ? void(message = json.at(1).get<M>()) : void()), ...);
  if (index >= sizeof...(M)) throw std::runtime_error("no message");
}

}  // namespace

std::string encode(const CheckTask& task) { return dump(task); }

CheckTask decodeTask(const std::string& text) { return Json::parse(text).get<CheckTask>(); }

std::string encode(const CheckMessage& message) {
  return dump(std::visit([&](const auto& m) { return Json{message.index(), m}; }, message));
}

std::optional<CheckMessage> decodeMessage(const std::string& line) {
  try {
    CheckMessage message;
    read(bounded_json::parse<Json>(line), message);
    return message;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace tolman::conformance
