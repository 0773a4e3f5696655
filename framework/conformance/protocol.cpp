// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/protocol.hpp"

#include <nlohmann/json.hpp>

namespace tolman::conformance {
namespace {

using Json = nlohmann::json;

std::string dump(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Message fromJson(const Json& json) {
  if (json.contains("step")) return Step{json["step"]};
  if (json.contains("topic")) return Topic{json["topic"]};
  if (json.contains("finding")) {
    return Finding{static_cast<Severity>(json["finding"].get<int>()), json.at("message"),
                   json.at("remedy")};
  }
  if (json.contains("figure")) return Figure{json["figure"], json.at("value"), json.at("unit")};
  if (json.contains("done")) return Done{};
  throw std::runtime_error("no message");
}

}  // namespace

std::string encode(const Task& task) {
  const LabOptions& lab = task.lab;
  return dump({{"check", task.check},
               {"report", task.report_descriptor},
               {"file", lab.file},
               {"id", lab.id},
               {"set", lab.set},
               {"seed", lab.seed},
               {"level", lab.level},
               {"scratch", lab.scratch.string()},
               {"patience", lab.patience}});
}

Task decodeTask(const std::string& text) {
  const Json json = Json::parse(text);
  Task task;
  task.check = json.at("check");
  task.report_descriptor = json.at("report");
  task.lab.file = json.at("file");
  task.lab.id = json.at("id");
  task.lab.set = json.at("set").get<std::vector<std::string>>();
  task.lab.seed = json.at("seed");
  task.lab.level = json.at("level");
  task.lab.scratch = json.at("scratch").get<std::string>();
  task.lab.patience = json.at("patience");
  return task;
}

std::string encode(const Message& message) {
  if (const auto* step = std::get_if<Step>(&message)) return dump({{"step", step->what}});
  if (const auto* topic = std::get_if<Topic>(&message)) return dump({{"topic", topic->what}});
  if (const auto* finding = std::get_if<Finding>(&message)) {
    return dump({{"finding", static_cast<int>(finding->severity)},
                 {"message", finding->message},
                 {"remedy", finding->remedy}});
  }
  if (const auto* figure = std::get_if<Figure>(&message)) {
    return dump({{"figure", figure->name}, {"value", figure->value}, {"unit", figure->unit}});
  }
  return dump({{"done", true}});
}

std::optional<Message> decodeMessage(const std::string& line) {
  try {
    return fromJson(Json::parse(line));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace tolman::conformance
