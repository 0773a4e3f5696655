// SPDX-License-Identifier: BSD-3-Clause
// Requests of other programs during a run: pose, map, routes and messages, over sockets.
#include <catch2/catch.hpp>
#include <thread>

#include "browser.hpp"
#include "event_log.hpp"
#include "watched_run.hpp"

namespace tolman::test {
namespace {

using nlohmann::json;

json ask(const WatchedRun& watched, const std::string& target, int status = 200) {
  const HttpAnswer answer = get(watched.port(), target);
  CAPTURE(target, answer.body);
  CHECK(answer.status == status);
  CHECK(answer.headers.at("content-type") == "application/json");
  CHECK(answer.headers.at("cache-control") == "no-store");
  return json::parse(answer.body);
}

/// The graph comes a quarter of a second after the last one at most.
json askPlan(const WatchedRun& watched, const std::string& query, std::size_t experiences) {
  while (ask(watched, "/api/map")["experiences"].size() < experiences) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return ask(watched, "/api/plan?" + query);
}

/// Messages of /api/events, as texts of JSON.
struct Events {
  explicit Events(int port) : socket(port, 10, 0, "/api/events") {
    REQUIRE(socket.status() == 101);
  }
  json next() {
    const auto message = socket.next();
    REQUIRE(message);
    REQUIRE(message->opcode == 1);
    return json::parse(message->bytes);
  }
  LiveSocket socket;
};

HttpAnswer raw(int port, const std::string& bytes) {
  Wire wire(port);
  wire.send(bytes);
  return readAnswer(wire);
}

}  // namespace

TEST_CASE("/api/pose has the pose of the frame that was processed last") {
  WatchedRun watched;
  CHECK(ask(watched, "/api/pose", 404)["error"] == "there is no pose yet");
  for (const std::int64_t frame : {6, 24}) {
    watched.frames(frame + 1 - watched.shown());
    const json pose = ask(watched, "/api/pose");
    CHECK(pose["frame"] == frame);
    CHECK(pose["time_s"] == Approx(1 + 0.1 * static_cast<double>(frame)));
    CHECK(pose["state"] == "tracking");
    CHECK(pose["scale_known"] == true);
    CHECK(pose["experience"] == frame / 10);
    CHECK(pose["forward_m"] == Approx(static_cast<double>(frame) + 0.5));
    CHECK(pose["right_m"] == 0);
    CHECK(pose["T_world_camera"]["position_m"][2] == pose["forward_m"]);
    CHECK(pose["T_world_camera"]["rotation_xyzw"] == json({0, 0, 0, 1}));
  }
}

TEST_CASE("/api/map has experiences and links") {
  WatchedRun watched;
  CHECK(ask(watched, "/api/map")["experiences"].empty());
  watched.frames(25);
  (void)askPlan(watched, "to=0", 3);
  const json map = ask(watched, "/api/map");
  CHECK(map["version"] == 2);
  CHECK(map["frame"] == 20);
  CHECK(map["experiences"][2] ==
        json({{"id", 2}, {"right_m", 0}, {"forward_m", 20}, {"up_m", 0}, {"heading_rad", 0}}));
  REQUIRE(map["links"].size() == 3);
  CHECK(map["links"][1] == json({{"from", 1},
                                 {"to", 2},
                                 {"kind", "odometry"},
                                 {"rejected", false},
                                 {"metres", 0},
                                 {"seconds", 0}}));
  CHECK(map["links"][2]["kind"] == "loop");
  CHECK(map["links"][2]["rejected"] == true);
}

TEST_CASE("/api/plan leads from here, or from a place, to the experience nearest to another") {
  WatchedRun watched;
  CHECK(ask(watched, "/api/plan?to=0,20", 404)["error"] == "the map is empty so far");
  watched.frames(25);
  const json home = askPlan(watched, "to=1,-3", 3);
  CHECK(home["from"] == 2);
  CHECK(home["to"] == 0);
  REQUIRE(home["legs"].size() == 3);  // the loop link from 2 to 0 is rejected
  CHECK(home["legs"][1]["experience"] == 1);
  CHECK(home["legs"][2]["forward_m"] == 0);
  CHECK(home["seconds"].is_null());  // the links of this map have no duration
  CHECK(home["legs"][2]["seconds"].is_null());
  CHECK(ask(watched, "/api/plan?to=0%2C11&from=0")["legs"].size() == 2);
  CHECK(ask(watched, "/api/plan?to=%31&from=%30")["to"] == 1);
  CHECK(ask(watched, "/api/plan?to=0,%2011&from=h%65re")["to"] == 1);
  CHECK(ask(watched, "/api/plan?to=0,+11")["to"] == 1);
  CHECK(ask(watched, "/api/plan?from=here&to=2")["legs"].size() == 1);
  CHECK(ask(watched, "/api/plan?to=0,11,5&from=0,0")["to"] == 1);
  CHECK_THAT(ask(watched, "/api/plan?to=3", 404)["error"].get<std::string>(),
             Catch::Contains("there is no experience 3"));
  CHECK(ask(watched, "/api/plan?to=-1", 404).contains("error"));
}

TEST_CASE("a plan that is asked for wrongly is refused with what to give") {
  WatchedRun watched;
  watched.frames(25);
  for (const char* query : {"",
                            "?",
                            "?to",
                            "?to=",
                            "?to=x",
                            "?to=1,",
                            "?to=1,2,3,4",
                            "?to=,1",
                            "?to=nan,1",
                            "?to=inf,0",
                            "?to=1e10,0",
                            "?to=1;2",
                            "?to=1%2C",
                            "?to=%",
                            "?to=1%3",
                            "?to=%zz",
                            "?to=1%20,",
                            "?to=%2C%2C",
                            "?to=1&to=2",
                            "?from=here",
                            "?from=&to=1",
                            "?to=1&x=2",
                            "?to=99999999999999999999",
                            "?to= 1",
                            "?to=1,2%00",
                            "?to=here,1"}) {
    const std::string target = std::string("/api/plan") + query;
    CAPTURE(target);
    const int status = get(watched.port(), target).status;
    CHECK(status == 400);
  }
  CHECK_THAT(ask(watched, "/api/plan?to=x", 400)["error"].get<std::string>(),
             Catch::Contains("to=12.5,-30"));
  CHECK(get(watched.port(), "/api/pose?x=1").status == 400);
  CHECK(get(watched.port(), "/api/map?").status == 200);
  CHECK(get(watched.port(), "/api/pose/").status == 404);
}

TEST_CASE("/api/events tells poses, decisions, loops and events as they come") {
  WatchedRun watched({{"rate", 1.0}});  // poses do not wait for the frames that are shown
  watched.frames(5);
  Events events(watched.port());
  CHECK(events.next()["type"] == "pose");
  watched.frames(6);
  std::vector<json> got;
  while (got.empty() || got.back()["frame"] != 10 || got.back()["type"] != "pose") {
    got.push_back(events.next());
  }
  std::int64_t last = -1;
  std::map<std::string, int> types;
  for (const json& message : got) {
    ++types[message["type"]];
    if (message["type"] != "pose") continue;
    CHECK(message["frame"] > last);
    last = message["frame"];
  }
  CHECK(types["decision"] == 1);
  CHECK(types["event"] == 1);
  CHECK(types["loop"] == 0);
  for (const json& message : got) {
    if (message["type"] == "decision") {
      CHECK(message["action"] == "create_experience");
      CHECK(message["experience"] == 1);
      CHECK(message["frame"] == 10);
    }
    if (message["type"] == "event") CHECK(message["message"] == "new view");
  }
}

TEST_CASE("loops are told, those that are believed only now among them, and the end") {
  WatchedRun watched;
  watched.frames(3);
  Events events(watched.port());
  REQUIRE(events.next()["type"] == "pose");
  TestFrame loop(3);
  loop.decision.action = Action::CloseLoop;
  loop.decision.experience = 0;
  loop.decision.earlier = {{1, 0, Eigen::Isometry3d::Identity(), Matrix6d::Identity()}};
  REQUIRE(watched.viewer->observe(loop.snapshot()).isOk());
  Status ended;
  std::thread finishing([&] { ended = watched.end(); });
  std::vector<json> loops;
  json message;
  do {
    message = events.next();
    if (message["type"] == "loop") loops.push_back(message);
  } while (message["type"] != "end");
  finishing.join();
  CHECK(ended.isOk());
  REQUIRE(loops.size() == 2);
  CHECK(loops[0] == json({{"type", "loop"}, {"frame", 3}, {"seen_at", 1}, {"experience", 0}}));
  CHECK(loops[1]["seen_at"] == 3);
  CHECK(message["state"] == "finished");
  CHECK(message["frame"] == 3);
}

TEST_CASE("a client of the events that sends anything is disconnected, others are refused") {
  WatchedRun watched;
  watched.frames(1);
  const std::string own = "127.0.0.1:" + std::to_string(watched.port());
  for (const std::string& text : {std::string("{}"), std::string(5000, 'x')}) {
    Events events(watched.port());
    events.socket.sendText(text);
    std::optional<LiveSocket::Message> message;
    do message = events.socket.next();
    while (message && message->opcode != 8);
    CHECK((!message || message->closeCode() == 1008 || message->closeCode() == 1009));
  }
  CHECK(get(watched.port(), "/api/events").status == 400);  // without an upgrade
  CHECK(raw(watched.port(), handshake("evil.example", "", "/api/events")).status == 403);
  CHECK(raw(watched.port(), handshake(own, "Origin: http://evil.example\r\n", "/api/events"))
            .status == 403);
  CHECK(raw(watched.port(), handshake(own, "", "/api/pose")).status == 404);
  for (const char* target : {"/api/pose", "/api/map", "/api/plan?to=0"}) {
    CHECK(get(watched.port(), target, "POST").status == 405);
    CHECK(get(watched.port(), target, "GET", "Origin: http://evil.example\r\n").status == 403);
    CHECK(get(watched.port(), target, "GET", "", "evil.example").status == 403);
  }
  CHECK(ask(watched, "/api/pose")["frame"] == 0);  // unharmed
}

TEST_CASE("a client that reads nothing misses messages, is told so, and delays nobody") {
  WatchedRun watched;
  watched.frames(1);
  LiveSocket silent(watched.port(), 10, 4096, "/api/events");
  watched.frames(3000, false);
  CHECK(ask(watched, "/api/pose")["frame"] == 3000);
  web_viewer::MessageLog log;
  for (int i = 0; i < 1500; ++i) log.append({std::to_string(i)});
  std::size_t next = 100;
  CHECK(*log.next(next) == R"({"type":"missed","messages":400})");
  CHECK(*log.next(next) == "500");
  CHECK(*log.next(next) == "501");
  next = log.end();
  CHECK(log.next(next) == nullptr);
}

}  // namespace tolman::test
