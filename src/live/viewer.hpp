#pragma once
#include <array>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <rigor/live/answer.hpp>
#include <string>

namespace rigor::live {

class Viewer;
/// What viewers come to and leave.
class Room {
 public:
  virtual void joined(std::shared_ptr<Viewer> viewer) = 0;
  virtual void said(Viewer& viewer, const std::string& message) = 0;
  virtual void left(Viewer& viewer) = 0;

 protected:
  ~Room() = default;
};

/// One WebSocket. Of each kind of news it keeps the latest that is not yet sent: nothing queues up for a slow reader.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  enum class News { scene, status, fault, frame };

  Viewer(boost::beast::tcp_stream stream, Room& room, int id);
  int id() const { return id_; }
  void accept(Request request);
  void tell(News kind, std::shared_ptr<const std::string> text);
  void go_away();
  /// A message has been on its way for more than ten seconds.
  bool stuck() const;
  void cut();

 private:
  void read();
  void write();
  void gone();
  bool too_many();

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  Room& room_;
  int id_;
  boost::beast::flat_buffer read_;
  Request request_;
  std::array<std::shared_ptr<const std::string>, 4> waiting_;
  std::shared_ptr<const std::string> sending_;
  std::chrono::steady_clock::time_point sent_at_, second_began_;
  int messages_ = 0;  // in this second
  bool open_ = false, closing_ = false;
};

}  // namespace rigor::live
