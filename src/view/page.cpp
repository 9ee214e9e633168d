#include <rigor/report/html.hpp>
#include <rigor/view/page.hpp>
#include <rigor/view/texts.hpp>

namespace rigor::view {

Outcome<std::string> render(const InteractivePage& page) {
  const std::string_view script = text_named(page.name + ".js", texts());
  if (script.empty()) return Fault{Fault::Kind::unsupported, "", std::string(text_named("reason.txt", texts()))};
  std::string inert;
  for (const char c : page.data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    if (c == '<') inert += "\\u003c";  // no end tag and no comment can begin inside the data
    else inert += c;
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; ";
  if (!page.connect.empty()) html += "img-src data:; connect-src " + report::escape(page.connect) + "; ";
  html += "script-src 'sha256-";
  html += text_named(page.name + ".js.sha256", texts());
  html += "'\">\n<title>" + report::escape(page.title) + "</title>\n";
  if (!page.connect.empty()) html += "<link rel=\"icon\" href=\"data:,\">\n";  // or a browser would ask the server for one
  html += "<style>";
  html += text_named(page.name + ".css", texts());
  html += "</style>\n</head>\n<body>\n";
  html += "<header><h1>" + report::escape(page.title) + "</h1><p>" + report::escape(page.lead) + "</p></header>\n";
  html += text_named(page.name + "-body.html", texts());
  if (!page.without_script.empty()) html += "<noscript><style>main,#transport{display:none}</style><div class=\"noscript\">" + page.without_script + "</div></noscript>\n";
  html += "<script type=\"application/json\" id=\"data\">" + inert + "</script>\n<script>";
  html += script;
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace rigor::view
