#include <algorithm>
#include <cmath>
#include <rigor/studies/pages.hpp>
#include <rigor/studies/problem.hpp>
#include <set>

namespace rigor::studies {
namespace {

std::string time_text(const Row* row) {
  if (row == nullptr) return "-";
  const double t = row->at("cpu_median");
  return t < 1e-3 ? brief(1e6 * t, "%.3g us") : brief(1e3 * t, "%.3g ms");
}
// 1.22 or 30700 instead of 3.07e+04: a column of a table, and as one reads it.
std::string plainly(double x) { return brief(x, x < 999.5 ? "%.3g" : "%.0f"); }
std::string microseconds(double seconds) { return plainly(1e6 * seconds); }
std::string setting(const Row& row) {
  if (row.cell.tolerance > 0) return "tol " + digits(row.cell.tolerance);
  return row.cell.steps > 0 ? std::to_string(row.cell.steps) + " steps" : "";
}
std::string named(const Row* row) {
  if (row == nullptr) return "none reaches it";
  const std::string with = setting(*row);
  return row->cell.method + (with.empty() ? "" : " (" + with + ")");
}

// Which method for which error: the cheapest of ours with and without the closed form, the cheapest peer, and the ratio.
Table choices(const std::vector<const Row*>& rows, bool peers) {
  std::vector<const Row*> ours, steppers, theirs;
  for (const Row* row : rows) {
    const std::string& m = row->cell.method;
    if (of_a_peer(*row)) theirs.push_back(row);
    else if (m.rfind("submission", 0) != 0 && m.find("cvode") == std::string::npos && m.find("arkode") == std::string::npos) {
      ours.push_back(row);
      if (m.rfind("exact", 0) != 0) steppers.push_back(row);
    }
  }
  Table t{"which method for which error: the cheapest run by median processor time", {"error, rad", "method", "time", "cheapest stepper", "time"}, {}, 2};
  if (peers) t.header.insert(t.header.end(), {"cheapest peer", "time", "peer / ours"});
  for (int k = 2; k <= 13; ++k) {
    const double error = std::pow(10, -k);
    const Row *best = cheapest(ours, error), *stepper = cheapest(steppers, error), *peer = cheapest(theirs, error);
    std::vector<std::string> line{brief(error, "%.0e"), named(best), time_text(best), named(stepper), time_text(stepper)};
    if (peers) {
      line.insert(line.end(), {named(peer), time_text(peer)});
      line.push_back(peer == nullptr || best == nullptr ? "-" : brief(peer->at("cpu_median") / best->at("cpu_median"), "%.0f"));
    }
    t.rows.push_back(line);
  }
  return t;
}

// What each method pays for an error it reaches, against the best of all.
Table costs(const std::vector<const Row*>& rows, double until) {
  Table t{"each method's cheapest run to an error: what it reached, time a second of motion, cost over the best of that error",
          {"method", "run", "to", "error, rad", "us a second", "over best"}, {}, 2};
  for (const Group& method : by_method(rows)) {
    const std::size_t before = t.rows.size();
    for (const double error : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const Row* row = cheapest(method.rows, error);
      if (row == nullptr) continue;
      const double time = row->at("cpu_median");
      t.rows.push_back({method.name, setting(*row), brief(error, "%.0e"), brief(row->at("attitude")), microseconds(time / until), plainly(time / cheapest(rows, error)->at("cpu_median"))});
    }
    if (t.rows.size() == before) t.rows.push_back({method.name, "none reaches 1e-03", "", "", "", ""});
  }
  return t;
}

// A row is on the front when nothing cheaper is as accurate.
std::vector<const Row*> front_of(std::vector<const Row*> rows) {
  rows.erase(std::remove_if(rows.begin(), rows.end(), [](const Row* r) { return !(r->at("attitude") >= 0); }), rows.end());
  std::sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) { return a->at("cpu_median") < b->at("cpu_median"); });
  std::vector<const Row*> front;
  for (const Row* row : rows)
    if (front.empty() || row->at("attitude") < front.back()->at("attitude")) front.push_back(row);
  return front;
}

}  // namespace

StudyPage work_page(const std::vector<Row>& rows) {
  StudyPage page{"Run time against error", "Every method's run time against its error at the end, in one run on one machine: ratios within a page count, times of two pages do not.", {}, ""};
  std::set<std::string> notes;
  for (const Group& problem : by_problem(rows)) {
    Section s = problem_section(problem.rows[0]->cell);
    report::Plot plot{"Processor time against attitude error: " + problem.name, "attitude error at the end, rad", "processor time, s", true, true, {}};
    Table reach{"cheapest median processor time, microseconds, that reaches an attitude error in rad", {"method", "1e-2", "1e-3", "1e-4", "1e-6", "1e-8", "1e-9", "1e-10", "1e-12", "1e-13", "least error"}, {}, 1};
    Table all{"every run; L and energy relative; each median is of the time before it", {"method", "setting", "attitude, rad", "L", "energy", "position, m", "evaluations", "CPU min, us", "median", "wall min, us", "median"}, {}, 2, true};
    bool peers = false;
    for (const Group& method : by_method(problem.rows)) {
      report::Series series{method.name, {}, {}, true, of_a_peer(*method.rows[0])};
      double least = std::nan("");
      for (const Row* row : method.rows) {
        series.x.push_back(row->at("attitude"));
        series.y.push_back(row->at("cpu_median"));
        least = std::fmin(least, row->at("attitude"));
        peers = peers || of_a_peer(*row);
        if (!row->note.empty()) notes.insert(row->cell.method + ": " + row->note);
        std::vector<std::string> line{row->cell.method, setting(*row)};
        for (const char* name : {"attitude", "momentum", "energy", "position"}) line.push_back(brief(row->at(name)));
        line.push_back(brief(row->at("evaluations"), "%.0f"));
        for (const char* name : {"cpu_min", "cpu_median", "wall_min", "wall_median"}) line.push_back(microseconds(row->at(name)));
        all.rows.push_back(line);
      }
      std::vector<std::string> line{method.name};
      for (const double error : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12, 1e-13}) {
        const Row* row = cheapest(method.rows, error);
        line.push_back(row == nullptr ? "-" : microseconds(row->at("cpu_median")));
      }
      line.push_back(brief(least));
      reach.rows.push_back(line);
      plot.series.push_back(series);
    }
    report::Series front{"front", {}, {}, true, false};
    std::vector<std::string> on_front;
    for (const Row* row : front_of(problem.rows)) front.x.push_back(row->at("attitude")), front.y.push_back(row->at("cpu_median")), on_front.push_back(row->cell.method);
    set_aside(plot, on_front);
    report::Plot efficiency{"The efficiency front: nothing cheaper is as accurate: " + problem.name, plot.x_label, plot.y_label, true, true, {front}};
    for (const report::Series& series : plot.series)
      if (series.name == "sheet" || series.name == "rk4" || series.dashed) efficiency.series.push_back(series), efficiency.series.back().aside = false;
    s.plots = {plot, efficiency};
    s.tables = {choices(problem.rows, peers), reach, costs(problem.rows, (*open_problem(problem.name, problem.rows[0]->cell.until))->until), all};
    page.sections.push_back(s);
  }
  Section how{"How it was measured",
              {"Thread processor time and wall time of a run from the start to the end of the problem: a warm-up, then seven samples of at least 2 ms each (three where a run takes longer than 0.2 s; "
               "peers: one run a sample, without making their world). An error of 0 is drawn nowhere: it is below the smallest double that a difference can have."},
              {}, {}, {}, {}};
  for (const std::string& note : notes) how.text.push_back(note + ".");
  page.sections.push_back(how);
  return page;
}

}  // namespace rigor::studies
