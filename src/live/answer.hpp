#pragma once
#include <boost/beast/http.hpp>
#include <string>

namespace rigor::live {

using Request = boost::beast::http::request<boost::beast::http::string_body>;
using Response = boost::beast::http::response<boost::beast::http::string_body>;

/// What the server has to give, and under which port's name.
struct Site {
  unsigned short port;
  std::string page;    ///< HTML
};

/// Empty when the request names this server by a local name and comes from no other site's page; else why it is
/// refused. A page of another site may reach a local port, by its number or by a name that resolves here, but it cannot
/// hide the Host it asked for, nor, where it may read an answer or talk on, its Origin. A WebSocket must name an Origin.
std::string refusal(const Request& request, unsigned short port, bool websocket);

/// The page at "/", or the status that says why not.
Response answer(const Request& request, const Site& site);
Response answer(const Request& request, boost::beast::http::status status, const std::string& why);

}  // namespace rigor::live
