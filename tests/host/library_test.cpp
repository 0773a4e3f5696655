// SPDX-License-Identifier: BSD-3-Clause
#include "host/library.hpp"

#include "host/fixture_plugins.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::load;
using tolman::test::refusalOf;

namespace {

OrRefusal<std::unique_ptr<Instance>> create(const std::string& library, const std::string& id) {
  auto loaded = load(library, id);
  REQUIRE(std::holds_alternative<LoadedPlugin>(loaded));
  return Instance::create(std::get<LoadedPlugin>(loaded), "odometry");
}

}  // namespace

TEST_CASE("a valid plugin loads and has its parameters") {
  const auto loaded = load("steady", "steady");
  REQUIRE(std::holds_alternative<LoadedPlugin>(loaded));
  const Schema& schema = std::get<LoadedPlugin>(loaded).schema;
  REQUIRE(schema.size() == 1);
  CHECK(schema[0].name == "speed");
  CHECK(std::get<double>(schema[0].default_value) == 10);
  CHECK(schema[0].unit == "m/s");
}

TEST_CASE("parameters that no configuration could give are refused") {
  const auto messageOf = [](const std::string& id) {
    const auto result = load("undeclared", id);
    CHECK(refusalOf(result).id == "plugin/bad-schema");
    return refusalOf(result).message;
  };
  CHECK(messageOf("reserved_name").ends_with("has a name that is reserved for the host"));
  CHECK(messageOf("default_outside").ends_with("has a default outside of its range"));
  CHECK(messageOf("declared_twice").ends_with("is declared twice"));
}

TEST_CASE("an undefined symbol is found when loading, not in the first call") {
  const auto result = load("missing_symbol", "missing_symbol");
  const auto& refusal = refusalOf(result);
  CHECK(refusal.id == "plugin/load-failed");
  CHECK(refusal.message.find("speedOfLight") != std::string::npos);
}

TEST_CASE("a manifest without its entry function is refused") {
  const auto result = load("entry_missing", "entry_missing");
  const auto& refusal = refusalOf(result);
  CHECK(refusal.id == "plugin/entry-missing");
  CHECK(refusal.message.find("tolman_plugin_entry_missing") != std::string::npos);
}

TEST_CASE("a constructor that throws, or makes nothing, is refused") {
  const auto throwing = create("misbehaving", "throws_in_constructor");
  CHECK(refusalOf(throwing).id == "plugin/create-failed");
  CHECK(refusalOf(throwing).message ==
        "odometry (throws_in_constructor), construct: threw: constructor gives up");
  CHECK(refusalOf(create("returns_null", "returns_null")).id == "plugin/null-instance");
}

TEST_CASE("a destructor that throws is reported, and the host continues") {
  auto created = create("misbehaving", "throws_in_destructor");
  REQUIRE(std::holds_alternative<std::unique_ptr<Instance>>(created));
  CHECK(std::get<std::unique_ptr<Instance>>(created)->destroy().message() ==
        "odometry (throws_in_destructor), destroy: threw: destructor gives up");
}
