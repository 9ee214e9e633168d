// The server as the network sees it: who is let in, what it withstands, how it stops. Clients are bounded in number and
// time: what one waits for in vain is cut after ten seconds, and the test fails.
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <rigor/live/server.hpp>
#include <thread>

namespace rigor::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Json = nlohmann::json;

LiveScene scene() {
  return *LiveScene::make(builtin_scene("assignment", 3), [](std::uint64_t seed) { return builtin_scene("assignment", seed); });
}
class Running {
 public:
  Running() : server_(std::move(Server::open(scene(), 0, [](unsigned short) { return std::string("<title>here</title>"); })).value()) {
    thread_ = std::thread([this] { server_->run([this] { return stop_.load(); }); });
  }
  ~Running() { stop(); }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  unsigned short port() const { return server_->port(); }
  std::string host() const { return "127.0.0.1:" + std::to_string(port()); }

 private:
  std::unique_ptr<Server> server_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

tcp::socket connect(asio::io_context& io, unsigned short port) {
  tcp::socket socket(io);
  socket.connect({asio::ip::address_v4::loopback(), port});
  return socket;
}
// One operation on `socket`, begun by start(handler). After ten seconds it is cut: timed_out. (A timeout of the socket itself
// would not do: asio waits again.)
template <class Start>
beast::error_code in_time(asio::io_context& io, tcp::socket& socket, Start start) {
  std::optional<beast::error_code> end;
  start([&](beast::error_code error, auto...) { end = error; });
  io.restart();
  io.run_for(std::chrono::seconds(10));
  if (end) return *end;
  socket.close();
  io.run();
  return asio::error::timed_out;
}
// What comes back for these bytes, to the end of the connection; "" when it is cut.
std::string sent(unsigned short port, const std::string& bytes) {
  asio::io_context io;
  tcp::socket socket = connect(io, port);
  beast::error_code error = in_time(io, socket, [&](auto done) { asio::async_write(socket, asio::buffer(bytes), done); });
  std::string back;
  if (!error) error = in_time(io, socket, [&](auto done) { asio::async_read(socket, asio::dynamic_buffer(back), done); });
  EXPECT_NE(error, asio::error::timed_out) << "no end within ten seconds";
  return back;
}
std::string get(unsigned short port, const std::string& target, const std::string& host, const std::string& more = "") {
  return sent(port, "GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
}
int status(const std::string& answer) { return answer.size() < 12 ? 0 : std::stoi(answer.substr(9, 3)); }

// A viewer: what it is told, by kind.
class Client {
 public:
  explicit Client(const Running& running, std::string origin = "") : socket_(connect(io_, running.port())) {
    if (origin.empty()) origin = "http://" + running.host();
    socket_.set_option(beast::websocket::stream_base::decorator([origin](beast::websocket::request_type& r) { r.set(http::field::origin, origin); }));
    const std::string host = running.host();
    refused_ = in_time([&](auto done) { socket_.async_handshake(host, "/socket", done); });
  }
  bool open() const { return !refused_; }
  void say(const std::string& text) {
    refused_ = in_time([&](auto done) { socket_.async_write(asio::buffer(text), done); });
  }
  void say_binary(const std::string& bytes) { socket_.binary(true), say(bytes), socket_.binary(false); }
  // The next message of this kind ("frame" for binary ones), or null at the end and after ten seconds.
  Json next(const std::string& kind) {
    for (const auto start = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - start < std::chrono::seconds(10);) {
      beast::flat_buffer buffer;
      refused_ = in_time([&](auto done) { socket_.async_read(buffer, done); });
      if (refused_) return nullptr;
      const std::string text = beast::buffers_to_string(buffer.data());
      if (!socket_.got_text()) {
        if (kind == "frame") return text.size();
        continue;
      }
      const Json told = Json::parse(text);
      if (told["kind"] == kind) return told;
    }
    return nullptr;
  }
  Json until(const std::function<bool(const Json&)>& holds) {
    for (int k = 0; k < 200; ++k)
      if (const Json told = next("status"); told.is_null() || holds(told)) return told;
    return nullptr;
  }
  // True once the server has ended the connection.
  bool ended() { return next("none").is_null() && refused_ && refused_ != asio::error::timed_out; }
  beast::error_code error() const { return refused_; }
  int close_code() const { return socket_.reason().code; }
  tcp::socket& raw() { return socket_.next_layer(); }

 private:
  template <class Start>
  beast::error_code in_time(Start start) { return live::in_time(io_, raw(), start); }
  asio::io_context io_;
  beast::websocket::stream<tcp::socket> socket_;
  beast::error_code refused_;
};
const std::string start_or_stop = R"({"do":"toggle","what":"running"})";

// ---- who is let in

TEST(Server, GivesThePageUnderItsLocalNames) {
  const Running here;
  for (const std::string& host : {here.host(), "localhost:" + std::to_string(here.port())}) {
    const std::string answer = get(here.port(), "/", host);
    EXPECT_EQ(status(answer), 200);
    EXPECT_NE(answer.find("<title>here</title>"), std::string::npos);
    EXPECT_NE(answer.find("X-Content-Type-Options: nosniff"), std::string::npos);
    EXPECT_NE(answer.find("frame-ancestors 'none'"), std::string::npos);
  }
}
TEST(Server, RefusesOtherHostsAndOrigins) {
  const Running here;
  const unsigned short port = here.port();
  const std::string number = std::to_string(port);
  for (const std::string& host : {"evil.example:" + number, std::string("evil.example"), std::string("127.0.0.1"), "127.0.0.1:" + std::to_string(port ^ 1),
                                 "127.0.0.1." + number, "127.0.0.1:" + number + ".evil.example", "x127.0.0.1:" + number, std::string("")})
    EXPECT_EQ(status(get(port, "/", host)), 403) << host;
  EXPECT_EQ(status(sent(port, "GET / HTTP/1.0\r\n\r\n")), 403) << "no host";
  EXPECT_EQ(status(get(port, "/", here.host(), "Host: evil.example\r\n")), 403) << "two hosts";
  for (const std::string origin : {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1"}) {
    EXPECT_EQ(status(get(port, "/", here.host(), "Origin: " + origin + "\r\n")), 403) << origin;
    EXPECT_FALSE(Client(here, origin).open()) << origin;
  }
  const std::string upgrade = "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  EXPECT_EQ(status(get(port, "/socket", here.host(), upgrade)), 403) << "a WebSocket that names no origin";
  EXPECT_EQ(status(get(port, "/socket", "evil.example:" + number, upgrade + "Origin: http://evil.example:" + number + "\r\n")), 403) << "a name that resolves here";
  EXPECT_EQ(status(get(port, "/socket", here.host(), "Origin: http://" + here.host() + "\r\n")), 426) << "no upgrade";
  EXPECT_TRUE(Client(here, "http://localhost:" + number).open());
}
TEST(Server, AnswersNothingElse) {
  const Running here;
  EXPECT_EQ(status(get(here.port(), "/../etc/passwd", here.host())), 404);
  EXPECT_EQ(status(get(here.port(), "/%2e%2e/", here.host())), 404);
  EXPECT_EQ(status(sent(here.port(), "DELETE / HTTP/1.1\r\nHost: " + here.host() + "\r\n\r\n")), 405);
  EXPECT_EQ(status(sent(here.port(), "POST / HTTP/1.1\r\nHost: " + here.host() + "\r\nContent-Length: 5\r\n\r\nhello")), 413);
  EXPECT_EQ(status(get(here.port(), "/", here.host(), "X: " + std::string(20000, 'x') + "\r\n")), 431);
  EXPECT_EQ(status(sent(here.port(), "\x16\x03\x01\x02 this is TLS, say\r\n\r\n")), 400);
}

// ---- what a viewer sees

TEST(Server, TellsEveryViewerWhatOnePresses) {
  const Running here;
  Client one(here), other(here);
  const Json first = one.next("scene");
  EXPECT_EQ(first["seed"], 3);
  EXPECT_EQ(first["bodies"].size(), 10u);
  EXPECT_FALSE(other.next("status")["running"]);
  one.say(start_or_stop);
  EXPECT_TRUE(other.until([](const Json& s) { return s["running"] && s["t"] > 0.05; })["running"]);
  other.say(R"({"do":"toggle","what":"vacuum"})");
  EXPECT_TRUE(one.until([](const Json& s) { return bool(s["vacuum"]); })["vacuum"]);
  other.say(R"({"do":"new"})");
  EXPECT_EQ(one.next("scene")["seed"], 4);
  one.say(R"({"do":"set","what":"restitution","value":2})");
  EXPECT_NE(one.next("fault")["text"].get<std::string>().find("restitution"), std::string::npos);
}
TEST(Server, LetsGoWhatALostViewerHeld) {
  const Running here;
  Client stays(here);
  {
    Client goes(here);
    goes.say(R"({"do":"hold","body":2,"at":[0,0,0],"to":[0,3,0]})");
    EXPECT_EQ(stays.until([](const Json& s) { return !s["held"].is_null(); })["held"], 2);
    goes.raw().close();
  }
  EXPECT_TRUE(stays.until([](const Json& s) { return s["held"].is_null(); })["held"].is_null());
}

// ---- what it withstands

TEST(Server, EndsConnectionsThatBreakTheProtocol) {
  const Running here;
  Client watcher(here);
  const auto raw = [&](const std::string& bytes) {
    Client client(here);
    beast::error_code error;
    asio::write(client.raw(), asio::buffer(bytes), error);
    return client.ended();
  };
  EXPECT_TRUE(raw(std::string("\x81\x05hello", 7))) << "a frame without a mask";
  EXPECT_TRUE(raw(std::string("\xf1\x80\0\0\0\0", 6))) << "reserved bits";
  EXPECT_TRUE(raw(std::string("\x83\x80\0\0\0\0", 6))) << "an opcode that is none";
  EXPECT_TRUE(raw(std::string("\x89\xfe\x01\x00\0\0\0\0", 8))) << "a ping of 256 bytes";
  EXPECT_TRUE(raw(std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14))) << "a message of 2^63 bytes";
  EXPECT_TRUE(raw(std::string("\x81\x82\0\0\0\0\xff\xff", 8))) << "a text that is not UTF-8";
  Client large(here);
  large.say("{\"do\":\"" + std::string(5000, 'x') + "\"}");
  EXPECT_TRUE(large.ended());
  watcher.say(start_or_stop);
  EXPECT_TRUE(watcher.until([](const Json& s) { return bool(s["running"]); })["running"]) << "the others go on";
}
TEST(Server, AnswersNonsenseWithAFault) {
  const Running here;
  Client client(here);
  client.say_binary(std::string("\0\1\2", 3));
  EXPECT_FALSE(client.next("fault").is_null());
  client.say("<script>alert(1)</script>");
  EXPECT_FALSE(client.next("fault").is_null());
}
TEST(Server, SurvivesRandomBytes) {
  const Running here;
  std::mt19937_64 random(20260414);
  for (int k = 0; k < 60; ++k) {
    std::string bytes;
    for (int i = 0; i < 200; ++i) bytes += char(random());
    if (k % 2) {
      Client client(here);
      ASSERT_TRUE(client.open());
      beast::error_code error;
      asio::write(client.raw(), asio::buffer(bytes), error);
    } else {
      asio::io_context io;
      tcp::socket socket = connect(io, here.port());
      asio::write(socket, asio::buffer("GET / HTTP/1.1\r\n" + bytes));
    }
  }
  EXPECT_EQ(status(get(here.port(), "/", here.host())), 200);
}
TEST(Server, CutsAFloodOfMessages) {
  const Running here;
  Client client(here);
  for (int k = 0; k < 1000 && !client.error(); ++k) client.say(R"({"do":"toggle","what":"gravity"})");
  EXPECT_TRUE(client.ended());
  EXPECT_EQ(status(get(here.port(), "/", here.host())), 200);
}
TEST(Server, TakesEightViewersAndSixtyFourConnections) {
  const Running here;
  std::vector<std::unique_ptr<Client>> viewers;
  for (int k = 0; k < 8; ++k) {
    viewers.push_back(std::make_unique<Client>(here));
    ASSERT_FALSE(viewers.back()->next("scene").is_null());
  }
  EXPECT_FALSE(Client(here).open()) << "a ninth";
  asio::io_context io;
  std::vector<tcp::socket> silent;
  for (int k = 0; k < 100; ++k) silent.push_back(connect(io, here.port()));
  int cut = 0;
  for (tcp::socket& socket : silent) {  // those above the bound are closed at once, the others wait for a request
    socket.non_blocking(true);
    char c;
    beast::error_code error = asio::error::would_block;
    for (int wait = 0; wait < 20 && error == asio::error::would_block; ++wait) {
      socket.read_some(asio::buffer(&c, 1), error);
      if (error == asio::error::would_block && cut == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      else break;
    }
    cut += error != asio::error::would_block;
  }
  EXPECT_EQ(cut, 36);
  viewers[0]->say(start_or_stop);
  EXPECT_TRUE(viewers[7]->until([](const Json& s) { return bool(s["running"]); })["running"]);
  silent.clear();
  viewers.clear();
  for (int k = 0; k < 100; ++k) {  // they have gone: there is room again
    Client again(here);
    if (again.open()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ADD_FAILURE() << "no room after all have gone";
}
// One that never reads holds nobody up.
TEST(Server, GoesOnBesideAViewerThatDoesNotRead) {
  const Running here;
  Client slow(here), quick(here);
  quick.say(start_or_stop);
  EXPECT_GT(quick.until([](const Json& s) { return s["t"] > 1; })["t"], 1);
}

// ---- how it stops

TEST(Server, SaysGoodbyeAndFreesItsPort) {
  Running here;
  Client client(here);
  ASSERT_FALSE(client.next("scene").is_null());
  asio::io_context io;
  tcp::socket silent = connect(io, here.port());
  std::thread reader([&] { EXPECT_TRUE(client.ended()); });
  here.stop();
  reader.join();
  EXPECT_EQ(client.close_code(), beast::websocket::close_code::going_away);
  const auto page = [](unsigned short) { return std::string(); };
  EXPECT_TRUE(Server::open(scene(), here.port(), page));
}
TEST(Server, SaysWhyItCannotOpen) {
  const Running here;
  const auto page = [](unsigned short) { return std::string(); };
  const auto taken = Server::open(scene(), here.port(), page);
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.fault().where, "port");
  EXPECT_NE(taken.fault().what.find("another program uses it"), std::string::npos) << taken.fault().text();
  const auto bare = Server::open(scene(), 0, [](unsigned short) -> Outcome<std::string> { return Fault{Fault::Kind::unsupported, "", "not bundled"}; });
  ASSERT_FALSE(bare);
  EXPECT_EQ(bare.fault().text(), "not bundled");
}

}  // namespace
}  // namespace rigor::live
