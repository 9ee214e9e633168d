#pragma once
#include <functional>
#include <memory>
#include <rigor/live/live_scene.hpp>
#include <string>

namespace rigor::live {

/// Serves one live scene on 127.0.0.1: its page over HTTP, what happens in it over a WebSocket at /socket. One thread, no
/// locks. Bounded whoever comes: 64 connections, 8 of them viewers; 10 s for a request; messages of 4096 bytes, 300 in a
/// second; a viewer that reads slowly is told less, and nothing queues up for it.
class Server {
 public:
  using PageFor = std::function<Outcome<std::string>(unsigned short port)>;
  /// Port 0 takes any free one; `page_for` makes the page for the port taken. Faults: out_of_range for a port that cannot
  /// be had, with the system's reason; the page's.
  static Outcome<std::unique_ptr<Server>> open(LiveScene scene, unsigned short port, const PageFor& page_for);
  ~Server();

  std::string address() const;
  unsigned short port() const;
  /// Serves until `stop` holds, which is asked at least ten times a second; then says goodbye and returns within a second.
  void run(const std::function<bool()>& stop);

 private:
  class Hub;
  explicit Server(std::unique_ptr<Hub> hub);
  std::unique_ptr<Hub> hub_;
};

}  // namespace rigor::live
