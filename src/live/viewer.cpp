#include <rigor/live/viewer.hpp>

namespace rigor::live {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_message = 4096;  // bytes
constexpr int most_messages = 300;             // in a second; a hand moves 60 times

}  // namespace

Viewer::Viewer(beast::tcp_stream stream, Room& room, int id) : socket_(std::move(stream)), room_(room), id_(id) {}

void Viewer::accept(Request request) {
  request_ = std::move(request);
  beast::get_lowest_layer(socket_).expires_never();  // from here on the WebSocket's own timeouts
  beast::get_lowest_layer(socket_).socket().set_option(boost::asio::ip::tcp::no_delay(true));
  socket_.set_option(websocket::stream_base::timeout{std::chrono::seconds(10), std::chrono::seconds(20), true});
  socket_.read_message_max(longest_message);
  socket_.async_accept(request_, [self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->open_ = true;
    self->room_.joined(self);
    self->read();
  });
}

void Viewer::read() {
  socket_.async_read(read_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) return self->gone();
    if (self->too_many()) {
      self->cut();
      return self->gone();
    }
    self->room_.said(*self, beast::buffers_to_string(self->read_.data()));
    self->read_.consume(self->read_.size());
    self->read();
  });
}
bool Viewer::too_many() {
  const auto now = Clock::now();
  if (now - second_began_ > std::chrono::seconds(1)) second_began_ = now, messages_ = 0;
  return ++messages_ > most_messages;
}

void Viewer::tell(News kind, std::shared_ptr<const std::string> text) {
  waiting_[std::size_t(kind)] = std::move(text);
  if (!sending_) write();
}
void Viewer::write() {
  if (!open_ || closing_) return;
  for (std::size_t kind = 0; kind < waiting_.size(); ++kind)
    if (waiting_[kind]) {
      sending_ = std::move(waiting_[kind]);
      waiting_[kind].reset();
      sent_at_ = Clock::now();
      socket_.binary(kind == std::size_t(News::frame));
      socket_.async_write(boost::asio::buffer(*sending_), [self = shared_from_this()](beast::error_code error, std::size_t) {
        self->sending_.reset();
        if (error) self->gone();
        else self->write();
      });
      return;
    }
}
bool Viewer::stuck() const { return sending_ && Clock::now() - sent_at_ > std::chrono::seconds(10); }

void Viewer::go_away() {
  if (!open_ || closing_) return;
  closing_ = true;
  socket_.async_close(websocket::close_code::going_away, [self = shared_from_this()](beast::error_code) {});
}
void Viewer::cut() {
  closing_ = true;
  beast::get_lowest_layer(socket_).close();
}
void Viewer::gone() {
  if (!open_) return;
  open_ = false;
  room_.left(*this);
}

}  // namespace rigor::live
