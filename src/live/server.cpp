#include <utility>  // asio 1.74 needs it before itself

#include <boost/asio.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <rigor/live/answer.hpp>
#include <rigor/live/server.hpp>
#include <rigor/live/viewer.hpp>
#include <set>

namespace rigor::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr int most_connections = 64;
constexpr std::size_t most_viewers = 8;
constexpr std::chrono::microseconds frame_time{16667}, idle_time{100000};
constexpr double work_in_a_frame = 0.012;  // s
constexpr int frames_between_accounts = 6;

std::shared_ptr<const std::string> shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

}  // namespace

class Server::Hub final : public Room {
 public:
  explicit Hub(LiveScene scene) : scene_(std::move(scene)) {}
  ~Hub() { viewers_.clear(); }  // before what their sockets live on

  Outcome<bool> listen(unsigned short port, const PageFor& page_for) {
    beast::error_code error;
    const tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    acceptor_.open(here.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(here, error);
    if (!error) acceptor_.listen(most_connections, error);
    if (error) {
      const bool taken = error == asio::error::address_in_use;
      return Fault{Fault::Kind::out_of_range, "port", std::to_string(port) + " cannot be had: " + (taken ? "another program uses it" : error.message()) +
                   "; without --port a free one is taken"};
    }
    site_.port = acceptor_.local_endpoint().port();
    auto page = page_for(site_.port);
    if (!page) return page.fault();
    site_.page = std::move(page).value();
    return true;
  }
  unsigned short port() const { return site_.port; }

  void run(const std::function<bool()>& stop) {
    accept();
    last_ = Clock::now();
    tick(stop);
    io_.run();
  }

  void joined(std::shared_ptr<Viewer> viewer) override {
    viewer->tell(Viewer::News::scene, shared(scene_.description()));
    viewer->tell(Viewer::News::status, shared(scene_.status()));
    viewer->tell(Viewer::News::frame, shared(scene_.frame()));
    viewers_.insert(std::move(viewer));
  }
  void said(Viewer& viewer, const std::string& message) override {
    const int scenes = scene_.scenes();
    if (const auto done = scene_.obey(message, viewer.id()); !done)
      viewer.tell(Viewer::News::fault, shared("{\"kind\":\"fault\",\"text\":" + nlohmann::json(done.fault().text()).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + "}"));
    if (scene_.scenes() != scenes) tell_all(Viewer::News::scene, scene_.description());
    changed_ = true;
  }
  void left(Viewer& viewer) override {
    scene_.left(viewer.id());
    viewers_.erase(viewer.shared_from_this());
    changed_ = true;
  }

  /// One HTTP request, which may become a viewer.
  class Visit;

 private:
  void accept();
  void tell_all(Viewer::News kind, std::string text) {
    const auto news = shared(std::move(text));
    for (const auto& viewer : viewers_) viewer->tell(kind, news);
  }
  void tick(const std::function<bool()>& stop) {
    if (stop()) return goodbye();
    const auto now = Clock::now();
    if (!viewers_.empty()) scene_.advance(std::min(0.25, std::chrono::duration<double>(now - last_).count()), work_in_a_frame);
    last_ = now;
    if (scene_.running() || changed_) tell_all(Viewer::News::frame, scene_.frame());
    if (changed_ || (scene_.running() && ++frames_ % frames_between_accounts == 0)) tell_all(Viewer::News::status, scene_.status());
    changed_ = false;
    for (const auto& viewer : viewers_)
      if (viewer->stuck()) viewer->cut();
    timer_.expires_after(viewers_.empty() ? idle_time : frame_time);
    timer_.async_wait([this, &stop](beast::error_code error) {
      if (!error) tick(stop);
    });
  }
  void goodbye() {
    beast::error_code ignored;
    acceptor_.close(ignored);
    for (const auto& viewer : viewers_) viewer->go_away();
    timer_.expires_after(std::chrono::milliseconds(500));
    timer_.async_wait([this](beast::error_code) { io_.stop(); });
  }

  LiveScene scene_;
  Site site_;
  int connections_ = 0, next_viewer_ = 0;
  long frames_ = 0;
  bool changed_ = false;
  Clock::time_point last_;
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer timer_{io_}, pause_{io_};
  std::set<std::shared_ptr<Viewer>> viewers_;
};

class Server::Hub::Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(tcp::socket socket, Hub& hub) : stream_(std::move(socket)), hub_(hub) {
    ++hub_.connections_;
    parser_.header_limit(8192);
    parser_.body_limit(std::uint64_t(0));
    stream_.expires_after(std::chrono::seconds(10));  // for all of it
  }
  ~Visit() { --hub_.connections_; }

  void begin() {
    http::async_read(stream_, buffer_, parser_, [self = shared_from_this()](beast::error_code error, std::size_t) { self->have(error); });
  }

 private:
  void have(beast::error_code error) {
    if (error == http::error::header_limit) return send(answer(parser_.get(), http::status::request_header_fields_too_large, "the request's head is too long"));
    if (error == http::error::body_limit) return send(answer(parser_.get(), http::status::payload_too_large, "a request has no body here"));
    if (error && error.category() == make_error_code(http::error::bad_method).category() && error != http::error::end_of_stream && error != http::error::partial_message)
      return send(answer(Request{http::verb::get, "/", 11}, http::status::bad_request, "this is no HTTP request"));
    if (error) return;
    Request request = parser_.release();
    if (request.target() != "/socket") return send(answer(request, hub_.site_));
    if (const std::string why = refusal(request, hub_.site_.port, true); !why.empty()) return send(answer(request, http::status::forbidden, why));
    if (!beast::websocket::is_upgrade(request)) return send(answer(request, http::status::upgrade_required, "here a WebSocket is spoken"));
    if (hub_.viewers_.size() >= most_viewers) return send(answer(request, http::status::service_unavailable, "eight look already"));
    std::make_shared<Viewer>(std::move(stream_), hub_, hub_.next_viewer_++)->accept(std::move(request));
  }
  void send(Response response) {
    response_ = std::move(response);
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code, std::size_t) {
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  Hub& hub_;
  beast::flat_buffer buffer_{16384};
  http::request_parser<http::string_body> parser_;
  Response response_;
};

void Server::Hub::accept() {
  acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
    if (!acceptor_.is_open()) return;
    if (!error && connections_ < most_connections) std::make_shared<Visit>(std::move(socket), *this)->begin();
    if (!error) return accept();
    pause_.expires_after(idle_time);  // out of descriptors, for example: others will go
    pause_.async_wait([this](beast::error_code stopped) {
      if (!stopped && acceptor_.is_open()) accept();
    });
  });
}

Server::Server(std::unique_ptr<Hub> hub) : hub_(std::move(hub)) {}
Server::~Server() = default;

Outcome<std::unique_ptr<Server>> Server::open(LiveScene scene, unsigned short port, const PageFor& page_for) {
  auto hub = std::make_unique<Hub>(std::move(scene));
  if (const auto ok = hub->listen(port, page_for); !ok) return ok.fault();
  return std::unique_ptr<Server>(new Server(std::move(hub)));
}
unsigned short Server::port() const { return hub_->port(); }
std::string Server::address() const { return "http://127.0.0.1:" + std::to_string(port()) + "/"; }
void Server::run(const std::function<bool()>& stop) { hub_->run(stop); }

}  // namespace rigor::live
