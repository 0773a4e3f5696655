// SPDX-License-Identifier: BSD-3-Clause
// Toy plugins with a parameter of each type.
#include "config/toy_system.hpp"

#include <array>

#include "support/paths.hpp"

namespace tolman::test {
namespace {

enum class Order : std::uint8_t { Forward, Backward, Pingpong };
constexpr std::array<std::string_view, 3> kOrderNames = {"forward", "backward", "pingpong"};
constexpr std::span<const std::string_view> enumNames(Order) { return kOrderNames; }

struct SourceParameters {
  std::string path;
  int first = 0;
  bool loop = false;
  Order order = Order::Forward;
  static constexpr auto declaration() {
    using P = SourceParameters;
    return parameters(parameter("path", &P::path).path().required().doc("Folder of the data."),
                      parameter("first", &P::first).range(0, 1e6).doc("First frame."),
                      parameter("loop", &P::loop).doc("Begin again at the end."),
                      parameter("order", &P::order).doc("Order of the frames."));
  }
};

struct OdometryParameters {
  int active_points = 2000;
  double scale = 1.25;
  std::vector<double> pyramid = {1, 0.5};
  std::string solver = "dense";
  static constexpr auto declaration() {
    using P = OdometryParameters;
    return parameters(
        parameter("active_points", &P::active_points)
            .range(50, 20000)
            .unit("points")
            .doc("Points in the window."),
        parameter("scale", &P::scale).range(0.5, 8).unit("pixels").doc("Step between scales."),
        parameter("pyramid", &P::pyramid).range(0, 16).doc("Weights of the levels."),
        parameter("solver", &P::solver).doc("Linear solver."));
  }
};

struct ObserverParameters {
  int port = 8080;
  static constexpr auto declaration() {
    return parameters(
        parameter("port", &ObserverParameters::port).range(1, 65535).doc("Port to listen on."));
  }
};

}  // namespace

Schema toySchema(const std::string& plugin) {
  if (plugin == "toy_source") return schemaOf<SourceParameters>();
  if (plugin == "toy_odometry") return schemaOf<OdometryParameters>();
  if (plugin == "toy_observer") return schemaOf<ObserverParameters>();
  return {};
}

config::Environment environmentOf(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const std::string& name) -> std::optional<std::string> {
    const auto found = variables.find(name);
    return found == variables.end() ? std::nullopt : std::optional(found->second);
  };
}

CheckedSystem checkSystem(const std::string& file, const std::vector<std::string>& overrides,
                          const std::map<std::string, std::string>& variables) {
  CheckedSystem system;
  const std::string path = file.starts_with('/') ? file : fixtures() + file;
  system.loaded = config::load(path, overrides, environmentOf(variables));
  system.problems = system.loaded.problems;
  system.config = config::parse(system.loaded, system.problems);
  for (const config::StageConfig& stage : system.config.stages) {
    if (stage.plugin.empty()) continue;
    system.values[stage.instance] =
        config::check(stage, toySchema(stage.plugin), system.config.folders, system.problems);
  }
  return system;
}

std::string CheckedSystem::complaints() const { return withoutFolder(config::format(problems)); }

std::string fixtures() { return inSource("tests/fixtures/config/"); }

std::string withoutFolder(std::string text) {
  const std::string folder = fixtures();
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) {
    text.erase(at, folder.size());
  }
  return text;
}

}  // namespace tolman::test
