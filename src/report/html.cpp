#include <algorithm>
#include <rigor/report/html.hpp>
#include <rigor/report/texts.hpp>

namespace rigor::report {
namespace {

// Length of the well-formed UTF-8 sequence at text[i], or 0.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  const bool overlong = (first == 0xE0 && byte(i + 1) < 0xA0) || (first == 0xF0 && byte(i + 1) < 0x90);
  const bool outside = (first == 0xED && byte(i + 1) >= 0xA0) || (first == 0xF4 && byte(i + 1) >= 0x90);
  return overlong || outside ? 0 : length;
}

// Of one well-formed sequence: C0 but newline and tab, DEL, C1; marks that turn the direction of what follows, with
// which a name can look like another; U+FFFE and U+FFFF, which XML forbids.
bool is_control(std::string_view one) {
  const auto first = static_cast<unsigned char>(one[0]);
  if (one.size() == 1) return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7F;
  if (one.size() == 2) return first == 0xC2 && static_cast<unsigned char>(one[1]) < 0xA0;
  return (one >= "\xE2\x80\xAA" && one <= "\xE2\x80\xAE") || (one >= "\xE2\x81\xA6" && one <= "\xE2\x81\xA9") || one == "\xEF\xBF\xBE" || one == "\xEF\xBF\xBF";
}

constexpr const char* replacement = "\xEF\xBF\xBD";

constexpr const char* sheet = R"css(
:root{--ink:#1b1f24;--soft:#57606a;--paper:#fff;--card:#f6f8fa;--line:#d0d7de;--good:#116329;--bad:#a40e26;--warn:#7a4b00;
 --link:#0550ae;--s0:#0b5cad;--s1:#b3420a;--s2:#1a7a3c;--s3:#7b3fb5;--s4:#8a6100;--s5:#0a7480;--s6:#a3195b;--s7:#555}
@media(prefers-color-scheme:dark){:root{--ink:#e6edf3;--soft:#9da7b1;--paper:#0d1117;--card:#161b22;--line:#30363d;
 --good:#56d364;--bad:#ff8182;--warn:#e3b341;--link:#79c0ff;--s0:#6cb6ff;--s1:#ff9a62;--s2:#6bc985;--s3:#c99bff;--s4:#dfb650;--s5:#58c7d4;
 --s6:#ff8abf;--s7:#a8b1ba}}
*{box-sizing:border-box}html{color-scheme:light dark}
body{margin:0 auto;max-width:66rem;padding:1.2rem;background:var(--paper);color:var(--ink);
 font:16px/1.5 system-ui,"Segoe UI",Roboto,"Liberation Sans","DejaVu Sans",sans-serif}
h1{font-size:1.7rem;line-height:1.2;margin:.3rem 0}h2{font-size:1.25rem;margin:2rem 0 .5rem;border-bottom:1px solid var(--line)}
h3{font-size:1.05rem;margin:1.2rem 0 .3rem}p.lead{color:var(--soft);margin:.2rem 0 1.2rem}
a{color:var(--link)}a:focus-visible,summary:focus-visible,.scroll:focus-visible{outline:3px solid var(--link);outline-offset:2px}
code,pre{font:0.9em/1.45 ui-monospace,"DejaVu Sans Mono","Liberation Mono",monospace}
pre{background:var(--card);border:1px solid var(--line);border-radius:6px;padding:.7rem;overflow-x:auto;white-space:pre-wrap;overflow-wrap:anywhere}
.scroll{overflow-x:auto;overflow-y:hidden}.scroll:has(>math){padding-block:.7rem}table{border-collapse:collapse;margin:.6rem 0;font-variant-numeric:tabular-nums}
p.caption{color:var(--soft);margin:.6rem 0 0}p.caption+table{margin-top:.2rem}th,td{border-bottom:1px solid var(--line);padding:.28rem .6rem;text-align:left;vertical-align:top}
th{font-weight:600}td.n,th.n{text-align:right}td.n{white-space:nowrap}.card{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:.8rem 1rem;margin:.8rem 0}
.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}.soft{color:var(--soft)}
figure{margin:1rem 0}figcaption{color:var(--soft);font-size:.92rem}svg{max-width:100%;height:auto}
footer{margin-top:3rem;border-top:1px solid var(--line);color:var(--soft);font-size:.85rem;overflow-wrap:anywhere}
svg text{fill:var(--ink);font:12px system-ui,"DejaVu Sans",sans-serif}svg .grid{stroke:var(--line);stroke-width:1}svg .axis{stroke:var(--soft);stroke-width:1}
math{font-size:1.15em;font-family:"Cambria Math","STIX Two Math","Latin Modern Math","Noto Sans Math",math}
.badge{display:inline-block;border:1px solid currentColor;border-radius:1rem;padding:0 .55rem;font-size:.82rem;font-weight:600;white-space:nowrap}
td.bar{min-width:8rem}td.bar i{display:block;height:.8rem;border-radius:3px;background:var(--s0)}
@media(max-width:40rem){th,td{padding:.28rem .35rem}.bar{display:none}svg text{font-size:17px}}
@media print{body{max-width:none;padding:0}details{display:block}pre{white-space:pre-wrap}.card,figure,tr{break-inside:avoid}}
)css";

}  // namespace

std::string clean(std::string_view text) {
  std::string out;
  out.reserve(text.size() + 16);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view one = text.substr(i, std::max<std::size_t>(length, 1));
    if (length == 0 || is_control(one)) out += replacement;
    else out += one;
    i += one.size();
  }
  return out;
}

std::string escape(std::string_view text) {
  std::string out;
  for (const char c : clean(text)) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  return out;
}

std::string render(const Page& page) {
  // the static picture of a plot is enough where no script was bundled
  const bool hovers = page.body.find("<figure class=\"plot\">") != std::string::npos && !text_named("hover.js", texts()).empty();
  const std::string script_source = hovers ? "'sha256-" + std::string(text_named("hover.js.sha256", texts())) + "'" : "'none'";
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "img-src data:; "
      "base-uri 'none'; form-action 'none'; script-src " +
      script_source + "\">\n<title>" + escape(page.title) + "</title>\n<style>" + sheet + page.style;
  if (hovers) html += text_named("hover.css", texts());
  html += "</style>\n</head>\n<body>\n<main>\n<h1>" + escape(page.title) + "</h1>\n";
  if (!page.lead.empty()) html += "<p class=\"lead\">" + escape(page.lead) + "</p>\n";
  html += page.body + "\n</main>\n";
  if (!page.footer.empty()) html += "<footer><p>" + escape(page.footer) + "</p></footer>\n";
  if (hovers) html += "<script>" + std::string(text_named("hover.js", texts())) + "</script>\n";
  return html + "</body>\n</html>\n";
}

std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& numbers, const std::string& caption) {
  const auto mark = [&](std::size_t column) {
    return std::find(numbers.begin(), numbers.end(), column) != numbers.end() ? " class=\"n\"" : "";
  };
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                     escape(caption.empty() ? "table" : caption) + "\">";
  if (!caption.empty()) html += "<p class=\"caption\">" + escape(caption) + "</p>";  // as wide as the page, where a <caption> is as wide as the table
  html += "<table><thead><tr>";
  for (std::size_t i = 0; i < header.size(); ++i)
    html += std::string("<th scope=\"col\"") + mark(i) + ">" + escape(header[i]) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += std::string("<td") + mark(i) + ">" + escape(row[i]) + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace rigor::report
