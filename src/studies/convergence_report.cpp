#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>
#include <rigor/studies/convergence.hpp>

namespace rigor::studies {
namespace {

std::string digits(double x) {
  char text[40];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}
std::string brief(const char* format, double x) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
std::string order_text(const Ladder& l) { return std::isnan(l.order) ? "-" : brief("%.2f", l.order); }
nlohmann::ordered_json number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

// Cheapest time of a ladder that reaches an error; NaN when none does.
double cheapest(const Ladder& l, double error) {
  double best = std::nan("");
  for (const Run& r : l.runs)
    if (r.error.attitude <= error && !(r.cpu_s >= best)) best = r.cpu_s;
  return best;
}

}  // namespace

std::string convergence_csv(const std::vector<Ladder>& ladders) {
  std::string out = "problem,method,steps,h,attitude,momentum,energy,position,cpu_s\n";
  for (const Ladder& l : ladders)
    for (const Run& r : l.runs)
      out += l.problem->name + "," + std::string(l.method->name) + "," + std::to_string(r.steps) + "," + digits(r.h) + "," + digits(r.error.attitude) + "," +
             digits(r.error.momentum) + "," + digits(r.error.energy) + "," + digits(r.error.position) + "," + digits(r.cpu_s) + "\n";
  return out;
}

std::string convergence_json(const std::vector<Ladder>& ladders, const std::string& command) {
  nlohmann::ordered_json json{{"schema", "rigor.study/1"}, {"command", command}, {"ladders", nlohmann::ordered_json::array()}};
  for (const Ladder& l : ladders) {
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const Run& r : l.runs)
      runs.push_back({{"steps", r.steps}, {"h", r.h}, {"attitude", number(r.error.attitude)}, {"momentum", number(r.error.momentum)},
                      {"energy", number(r.error.energy)}, {"position", number(r.error.position)}, {"cpu_s", r.cpu_s}});
    json["ladders"].push_back({{"problem", l.problem->name}, {"method", l.method->name}, {"nominal_order", l.method->order}, {"fitted_order", number(l.order)},
                               {"points_used", l.used}, {"runs", runs}});
  }
  return json.dump(2) + "\n";
}

std::string convergence_text(const std::vector<Ladder>& ladders) {
  std::string out;
  const Problem* last = nullptr;
  for (const Ladder& l : ladders) {
    if (l.problem != last) {
      out += (last == nullptr ? "" : "\n") + l.problem->name + ": " + l.problem->says + "\n";
      out += "  method                  order  fitted   coarsest h  error rad   finest h    error rad\n";
      last = l.problem;
    }
    char line[200];
    if (l.runs.empty()) continue;
    std::snprintf(line, sizeof line, "  %-24s %4d  %6s   %-10.3g  %-10.2e  %-10.3g  %.2e\n", std::string(l.method->name).c_str(), l.method->order, order_text(l).c_str(),
                  l.runs.front().h, l.runs.front().error.attitude, l.runs.back().h, l.runs.back().error.attitude);
    out += line;
  }
  return out;
}

std::string convergence_html(const std::vector<Ladder>& ladders, const std::string& kind, const std::string& command) {
  using report::escape;
  report::Page page;
  const bool work = kind == "work-precision";
  page.title = work ? "Run time against error" : "Error against step";
  page.lead = "Every method's error at the end of the problem, against a reference whose own error is stated.";
  for (std::size_t first = 0; first < ladders.size();) {
    const Problem& problem = *ladders[first].problem;
    report::Plot plot;
    plot.title = page.title + ": " + problem.name;
    plot.log_x = plot.log_y = true;
    plot.x_label = work ? "attitude error at the end, rad" : "step h, s";
    plot.y_label = work ? "processor time, s" : "attitude error at the end, rad";
    std::vector<std::vector<std::string>> rows;
    std::size_t k = first;
    for (; k < ladders.size() && ladders[k].problem == &problem; ++k) {
      const Ladder& l = ladders[k];
      report::Series series{std::string(l.method->name), {}, {}};
      for (const Run& r : l.runs) {
        series.x.push_back(work ? r.error.attitude : r.h);
        series.y.push_back(work ? r.cpu_s : r.error.attitude);
      }
      plot.series.push_back(series);
      std::vector<std::string> row{std::string(l.method->name), std::to_string(l.method->order), order_text(l), std::to_string(l.used)};
      if (work)
        for (const double error : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
          const double t = cheapest(l, error);
          row.push_back(std::isnan(t) ? "-" : brief("%.3g", 1e6 * t));
        }
      else if (!l.runs.empty()) {
        const Errors& e = l.runs.back().error;
        for (const double x : {e.attitude, e.momentum, e.energy, e.position}) row.push_back(brief("%.2e", x));
      }
      rows.push_back(row);
    }
    page.body += "<h2>" + escape(problem.name) + "</h2><p>" + escape(problem.says) + "</p>" + report::figure(plot, "Reference: " + escape(problem.reference) + ".");
    const std::vector<std::string> header = work ? std::vector<std::string>{"method", "order", "fitted", "points", "1e-2", "1e-4", "1e-6", "1e-9", "1e-12"}
                                                 : std::vector<std::string>{"method", "order", "fitted", "points", "attitude, rad", "angular momentum", "energy", "position, m"};
    page.body += report::table(header, rows, {1, 2, 3, 4, 5, 6, 7, 8}, work ? "cheapest processor time in microseconds that reaches an attitude error" : "errors at the finest step");
    first = k;
  }
  page.footer = command;
  return report::render(page);
}

}  // namespace rigor::studies
