#include <rigor/base/promise.hpp>
#include <rigor/report/html.hpp>
#include <rigor/view/replay.hpp>
#include <rigor/view/texts.hpp>

namespace rigor::view {

std::string_view web_file(std::string_view name) {
  for (const Text& file : texts())
    if (file.path.size() > name.size() && file.path.substr(file.path.size() - name.size()) == name && file.path[file.path.size() - name.size() - 1] == '/')
      return file.content;
  promise(false, "a web file is asked for by a name that bundle.cmake makes");
  return {};
}

Outcome<std::string> replay_page(const std::vector<Recording>& runs, const std::string& title, const std::string& lead) {
  if (web_file("replay.js").empty()) return Fault{Fault::Kind::unsupported, "", std::string(web_file("reason.txt"))};
  nlohmann::ordered_json data{{"schema", "rigor.replay/1"}, {"title", title}, {"runs", nlohmann::ordered_json::array()}};
  for (const Recording& run : runs) data["runs"].push_back(run.packed());
  std::string json = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace), inert;
  inert.reserve(json.size());
  for (const char c : json)  // no end tag and no comment can begin inside the data
    if (c == '<') inert += "\\u003c";
    else inert += c;
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; "
      "script-src 'sha256-";
  page += web_file("replay.js.sha256");
  page += "'\">\n<title>" + report::escape(title) + "</title>\n<style>";
  page += web_file("replay.css");
  page += "</style>\n</head>\n<body>\n";
  page += "<header><h1>" + report::escape(title) + "</h1><p>" + report::escape(lead) + "</p></header>\n";
  page += web_file("replay-body.html");
  page += "<script type=\"application/json\" id=\"data\">" + inert + "</script>\n<script>";
  page += web_file("replay.js");
  return page + "</script>\n</body>\n</html>\n";
}

}  // namespace rigor::view
