#include <boost/beast/core/string.hpp>
#include <rigor/live/answer.hpp>

namespace rigor::live {
namespace {

namespace http = boost::beast::http;

// host[:port] of this server, by either local name; a browser leaves the port out where it is 80
bool local(boost::beast::string_view host, unsigned short port) {
  const std::string number = ":" + std::to_string(port);
  for (const std::string name : {"127.0.0.1", "localhost"})
    if (boost::beast::iequals(host, name + number) || (port == 80 && boost::beast::iequals(host, name))) return true;
  return false;
}

Response respond(const Request& request, http::status status, const char* type, const std::string& body) {
  Response response(status, request.version());
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", "frame-ancestors 'none'");  // the page carries the rest itself
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Referrer-Policy", "no-referrer");
  response.set("X-Content-Type-Options", "nosniff");
  response.keep_alive(false);
  if (request.method() != http::verb::head) response.body() = body;
  response.prepare_payload();
  return response;
}

}  // namespace

std::string refusal(const Request& request, unsigned short port, bool websocket) {
  if (request.count(http::field::host) != 1 || !local(request[http::field::host], port))
    return "this server answers to 127.0.0.1:" + std::to_string(port) + " and localhost:" + std::to_string(port) + " only";
  if (request.count(http::field::origin) == 0) return websocket ? "a WebSocket must name its Origin" : "";
  const boost::beast::string_view origin = request[http::field::origin];
  const bool own = request.count(http::field::origin) == 1 && origin.starts_with("http://") && local(origin.substr(7), port);
  return own ? "" : "pages of other origins may not ask here";
}

Response answer(const Request& request, http::status status, const std::string& why) {
  Response response = respond(request, status, "text/plain; charset=utf-8", why + "\n");
  if (status == http::status::method_not_allowed) response.set(http::field::allow, "GET, HEAD");
  return response;
}

Response answer(const Request& request, const Site& site) {
  if (const std::string why = refusal(request, site.port, false); !why.empty()) return answer(request, http::status::forbidden, why);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return answer(request, http::status::method_not_allowed, "there is nothing here but to look at");
  if (request.target() != "/") return answer(request, http::status::not_found, "the page is at /");
  return respond(request, http::status::ok, "text/html; charset=utf-8", site.page);
}

}  // namespace rigor::live
