// SPDX-License-Identifier: BSD-3-Clause
#include "host/library.hpp"

#include "host/fixture_plugins.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::load;

namespace {

std::unique_ptr<Instance> create(const std::string& library, const std::string& id) {
  return Instance::create(load(library, id), "odometry");
}

}  // namespace

TEST_CASE("a valid plugin loads and has its parameters") {
  const Schema schema = load("steady", "steady").schema;
  REQUIRE(schema.size() == 1);
  CHECK(schema[0].name == "speed");
  CHECK(std::get<double>(schema[0].default_value) == 10);
  CHECK(schema[0].unit == "m/s");
}

TEST_CASE("parameters that no configuration could give are refused") {
  const auto messageOf = [](const std::string& id) {
    const Refusal refusal = REFUSAL_OF(load("undeclared", id));
    CHECK(refusal.id == "plugin/bad-schema");
    return refusal.message;
  };
  CHECK(messageOf("reserved_name").ends_with("has a name that is reserved for the host"));
  CHECK(messageOf("default_outside").ends_with("has a default outside of its range"));
  CHECK(messageOf("declared_twice").ends_with("is declared twice"));
}

TEST_CASE("an undefined symbol is found when loading, not in the first call") {
  const Refusal refusal = REFUSAL_OF(load("missing_symbol", "missing_symbol"));
  CHECK(refusal.id == "plugin/load-failed");
  CHECK(refusal.message.find("speedOfLight") != std::string::npos);
}

TEST_CASE("a manifest without its entry function is refused") {
  const Refusal refusal = REFUSAL_OF(load("entry_missing", "entry_missing"));
  CHECK(refusal.id == "plugin/entry-missing");
  CHECK(refusal.message.find("tolman_plugin_entry_missing") != std::string::npos);
}

TEST_CASE("a constructor that throws, or makes nothing, is refused") {
  const Refusal throwing = REFUSAL_OF(create("misbehaving", "throws_in_constructor"));
  CHECK(throwing.id == "plugin/create-failed");
  CHECK(throwing.message ==
        "odometry (throws_in_constructor), construct: threw: constructor gives up");
  CHECK(REFUSAL_OF(create("returns_null", "returns_null")).id == "plugin/null-instance");
}

TEST_CASE("a destructor that throws is reported, and the host continues") {
  CHECK(create("misbehaving", "throws_in_destructor")->destroy().message() ==
        "odometry (throws_in_destructor), destroy: threw: destructor gives up");
}
