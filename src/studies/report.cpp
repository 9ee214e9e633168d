#include <boost/version.hpp>
#include <gsl/gsl_version.h>
#include <sundials/sundials_config.h>

#include <Eigen/Core>
#include <algorithm>
#include <fstream>
#include <rigor/report/formula.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/wrap.hpp>
#include <rigor/studies/report.hpp>
#include <thread>

namespace rigor::studies {
namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}
std::string first_load() {
  std::ifstream in("/proc/loadavg");
  std::string load;
  in >> load;
  return load;
}
std::string padded(const std::string& text, std::size_t to, bool right) {
  const std::string spaces(to > report::columns(text) ? to - report::columns(text) : 0, ' ');
  return right ? spaces + text : text + spaces;
}
constexpr std::size_t terminal = 80;

// The table in columns, one blank apart where two are too many; those that do not fit a line go on below, beside the
// words once more.
std::string columns_text(const Table& t) {
  const std::size_t margin = 4;
  std::vector<std::size_t> widths;
  std::size_t all = margin, left = margin, widest = 0;  // left: of the words; widest: of the numbers
  for (std::size_t i = 0; i < t.header.size(); ++i) {
    std::size_t w = report::columns(t.header[i]);
    for (const auto& row : t.rows) w = std::max(w, i < row.size() ? report::columns(row[i]) : 0);
    widths.push_back(w);
    all += w + 1;
    if (i < t.words) left += w + 2;
    else widest = std::max(widest, w);
  }
  const bool in_a_line = all <= terminal + 1;
  if (!in_a_line && left + widest > terminal) {  // sentences, or names that leave no room: an item a row
    std::string items;
    for (const auto& row : t.rows) {
      std::string item = "- ";
      for (std::size_t i = 0; i < row.size(); ++i) item += (i > 0 ? ", " : "") + t.header[i] + " " + row[i];
      items += item + "\n";
    }
    return report::filled(items, terminal, margin);
  }
  const std::size_t gap = in_a_line && all + widths.size() > terminal + 2 ? 1 : 2, words = std::min(t.words, widths.size());
  std::string out;
  for (std::size_t first = words, last; first < widths.size() || first == words; first = last) {
    std::size_t used = margin;
    for (std::size_t i = 0; i < words; ++i) used += widths[i] + gap;
    for (last = first; last < widths.size() && (last == first || used + widths[last] <= terminal); ++last) used += widths[last] + gap;
    const auto line = [&](const std::vector<std::string>& cells) {
      std::string text(margin, ' ');
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (i < words || (i >= first && i < last)) text += padded(cells[i], widths[i], i >= t.words) + std::string(gap, ' ');
      while (!text.empty() && text.back() == ' ') text.pop_back();
      out += text + "\n";
    };
    if (first > words) out += "\n";
    line(t.header);
    for (const auto& row : t.rows) line(row);
    if (first == last) break;  // words alone
  }
  return out;
}

std::ptrdiff_t aside(const report::Plot& plot) {
  return std::count_if(plot.series.begin(), plot.series.end(), [](const report::Series& s) { return s.aside; });
}

std::string cell_markdown(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::vector<std::string> machine() {
  return {processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads, load " + first_load() + " when the page was made",
          std::string("compiler ") + __VERSION__ + ", -O2 -ffp-contract=off",
          std::string("rigor ") + RIGOR_VERSION + ", Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION) +
              ", Boost " BOOST_LIB_VERSION ", GSL " GSL_VERSION ", SUNDIALS " SUNDIALS_VERSION,
          "no random numbers: there is no seed"};
}

std::string page_html(const StudyPage& page) {
  using report::escape;
  report::Page out;
  out.title = page.title;
  out.lead = page.lead;
  if (!page.unfinished.empty()) out.body += "<p class=\"warn\"><strong>" + escape(page.unfinished) + "</strong></p>";
  for (const Section& s : page.sections) {
    out.body += "<h2>" + escape(s.heading) + "</h2>";
    for (const std::string& text : s.text) out.body += "<p>" + escape(text) + "</p>";
    for (const std::string& id : s.laws) out.body += "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">" + report::formula_html(id) + "</div>";
    if (!s.givens.empty()) {
      out.body += "<pre>";
      for (const std::string& line : s.givens) out.body += escape(line) + "\n";
      out.body += "</pre>";
    }
    for (const report::Plot& plot : s.plots) out.body += report::figure(plot, escape(plot.title) + (aside(plot) > 0 ? "; " + std::to_string(aside(plot)) + " more curves by a click on their names" : ""));
    for (const Table& t : s.tables) {
      std::vector<std::size_t> numbers;
      for (std::size_t i = t.words; i < t.header.size(); ++i) numbers.push_back(i);
      out.body += report::table(t.header, t.rows, numbers, t.caption);
    }
  }
  out.body += "<h2>Made by</h2><pre>" + escape(page.command) + "\n";
  for (const std::string& line : machine()) out.body += escape(line) + "\n";
  out.body += "</pre>";
  out.footer = page.command;
  return report::render(out);
}

std::string page_markdown(const StudyPage& page) {
  std::string out = "# " + page.title + "\n\n" + page.lead + "\n\nMade by `" + page.command + "`\n" + (page.unfinished.empty() ? "" : "\n**" + page.unfinished + "**\n");
  int figure = 0;
  for (const Section& s : page.sections) {
    out += "\n## " + s.heading + "\n";
    for (const std::string& text : s.text) out += "\n" + text + "\n";
    if (!s.laws.empty() || !s.givens.empty()) {
      out += "\n```\n";
      for (const std::string& id : s.laws) out += report::formula_text(id) + "\n";
      for (const std::string& line : s.givens) out += line + "\n";
      out += "```\n";
    }
    for (const report::Plot& plot : s.plots) out += "\n![" + plot.title + "](figure-" + std::to_string(++figure) + ".svg)\n" + (aside(plot) > 0 ? "\n" + std::to_string(aside(plot)) + " more curves can be switched on in study.html.\n" : "");
    for (const Table& t : s.tables) {
      if (t.every_run) continue;
      out += "\n" + t.caption + "\n\n|";
      for (const std::string& h : t.header) out += " " + cell_markdown(h) + " |";
      out += "\n|";
      for (std::size_t i = 0; i < t.header.size(); ++i) out += i < t.words ? "---|" : "---:|";
      out += "\n";
      for (const auto& row : t.rows) {
        out += "|";
        for (const std::string& c : row) out += " " + cell_markdown(c) + " |";
        out += "\n";
      }
    }
  }
  out += "\n## Machine\n\n";
  for (const std::string& line : machine()) out += "- " + line + "\n";
  return out;
}
std::vector<std::string> page_figures(const StudyPage& page) {
  std::vector<std::string> figures;
  for (const Section& s : page.sections)
    for (const report::Plot& plot : s.plots) figures.push_back(report::svg_file(plot));
  return figures;
}

std::string page_text(const StudyPage& page) {
  std::string out = page.unfinished.empty() ? "" : page.unfinished + "\n";
  for (const Section& s : page.sections) {
    out += report::filled(s.heading, terminal, 0);
    for (const Table& t : s.tables)
      if (!t.every_run) out += report::filled(t.caption, terminal, 2) + columns_text(t) + "\n";
  }
  return out;
}

}  // namespace rigor::studies
