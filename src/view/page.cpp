#include <rigor/base/promise.hpp>
#include <rigor/report/html.hpp>
#include <rigor/view/page.hpp>
#include <rigor/view/texts.hpp>

namespace rigor::view {

std::string_view web_file(std::string_view name) {
  for (const Text& file : texts())
    if (file.path.size() > name.size() && file.path.substr(file.path.size() - name.size()) == name && file.path[file.path.size() - name.size() - 1] == '/')
      return file.content;
  promise(false, "a web file is asked for by a name that bundle.cmake makes");
  return {};
}

Outcome<std::string> render(const InteractivePage& page) {
  const std::string_view script = web_file(page.name + ".js");
  if (script.empty()) return Fault{Fault::Kind::unsupported, "", std::string(web_file("reason.txt"))};
  std::string inert;
  for (const char c : page.data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    if (c == '<') inert += "\\u003c";  // no end tag and no comment can begin inside the data
    else inert += c;
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; ";
  if (!page.connect.empty()) html += "img-src data:; connect-src " + report::escape(page.connect) + "; ";
  html += "script-src 'sha256-";
  html += web_file(page.name + ".js.sha256");
  html += "'\">\n<title>" + report::escape(page.title) + "</title>\n";
  if (!page.connect.empty()) html += "<link rel=\"icon\" href=\"data:,\">\n";  // or a browser would ask the server for one
  html += "<style>";
  html += web_file(page.name + ".css");
  html += "</style>\n</head>\n<body>\n";
  html += "<header><h1>" + report::escape(page.title) + "</h1><p>" + report::escape(page.lead) + "</p></header>\n";
  html += web_file(page.name + "-body.html");
  html += "<script type=\"application/json\" id=\"data\">" + inert + "</script>\n<script>";
  html += script;
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace rigor::view
