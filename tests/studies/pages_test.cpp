// The pages of studies: what their tables, pictures and texts say of the rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <rigor/studies/contact.hpp>
#include <rigor/studies/drift.hpp>
#include <rigor/studies/flight.hpp>
#include <rigor/studies/pages.hpp>
#include <rigor/studies/plan.hpp>
#include <sstream>

namespace rigor::studies {
namespace {

std::vector<Row> measured(const StudyRequest& request) {
  const auto cells = plan(request);
  EXPECT_TRUE(cells) << cells.fault().text();
  std::vector<Row> rows;
  for (const Cell& cell : *cells) rows.push_back(cell.study == "drift" ? drift(cell) : cell.study == "stability" ? stability(cell) : cell.study == "contact" ? contact(cell) : fly(cell));
  return rows;
}
const Table& named(const Section& section, const std::string& caption) {
  return *std::find_if(section.tables.begin(), section.tables.end(), [&](const Table& t) { return t.caption.rfind(caption, 0) == 0; });
}
void expect_eighty_columns(const std::string& text) {
  EXPECT_GT(text.size(), 100u);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }), 80) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
  }
}
std::vector<StudyRequest> every_kind(const std::vector<std::string>& methods) {
  std::vector<StudyRequest> all;
  for (const std::string& kind : study_kinds()) {
    StudyRequest r{kind, {}, methods};
    if (kind == "work-precision") r.problems = {"short-A"}, r.coarsest = 10;
    if (kind == "drift") r.steps = 100;
    else if (kind != "stability") r.rungs = 3;
    all.push_back(r);
  }
  return all;
}

TEST(Pages, ShowEveryRunTheReferenceAndTheMachine) {
  for (StudyRequest& r : every_kind({"sheet", "split2"})) {
    if (r.kind == "stability") r.problems = {"case-A", "mass"};  // the other maps take seconds
    const std::vector<Row> rows = measured(r);
    const StudyPage page = study_page(r.kind, rows, "rigor study " + r.kind, rows.size());
    for (const std::string& text : {page_html(page), page_markdown(page)}) {
      EXPECT_NE(text.find("rigor study " + r.kind), std::string::npos);
      EXPECT_NE(text.find("SUNDIALS"), std::string::npos);
      EXPECT_EQ(text.find("http://rigor"), std::string::npos);
      if (r.kind == "convergence") {
        EXPECT_NE(text.find("Taylor series of order 40"), std::string::npos);
      }
    }
  }
}

// What an interrupt left out is not to be missed: the page, the terminal and the README say it first.
TEST(Pages, SayThatAStudyWasInterrupted) {
  for (const StudyRequest& r : every_kind({"sheet"})) {
    const std::string said = "0 of 7 cells; interrupted";
    const StudyPage page = study_page(r.kind, {}, "x", 7);
    EXPECT_EQ(page_text(page).rfind(said + "\n", 0), 0u);
    for (const std::string& text : {page_html(page), page_markdown(page)}) EXPECT_NE(text.find(said), std::string::npos) << r.kind;
    EXPECT_EQ(page_html(study_page(r.kind, {}, "x", 0)).find("interrupted"), std::string::npos);
  }
}

// Every study, with the methods of the longest names, a submission's name, and runs that failed with something to say.
TEST(Pages, FitEightyColumns) {
  const std::string submission = "submission someone-with-a-long-name 0123456789ab", words = "unsupported: the function 'update' of the submission returned a matrix that is no rotation, off by 0.25, after 17 of 50 steps";
  for (StudyRequest& r : every_kind({"sheet", "euler-momentum-exponential"})) {
    if (r.kind == "contact") r.methods = {"sheet", "euler-momentum-exponential", "located"};
    if (r.kind == "stability") r.problems = {"case-A", "mass"};
    std::vector<Row> rows = measured(r);
    const std::size_t own = rows.size();
    for (std::size_t i = 0; i < own; ++i) {
      if (rows[i].cell.method != "sheet") continue;
      Row their = rows[i];
      their.cell.method = submission;
      rows.push_back(their);
    }
    rows.push_back({{r.kind, rows[0].cell.problem, submission, 50, 0, 0, rows[0].cell.x, rows[0].cell.y}, {}, words, ""});
    SCOPED_TRACE(r.kind);
    const std::string text = page_text(study_page(r.kind, rows, "x", rows.size()));
    EXPECT_NE(text.find("after 17"), std::string::npos);
    expect_eighty_columns(text);
  }
}
TEST(Pages, FitEightyColumnsWithEveryMethod) {
  for (const char* kind : {"convergence", "drift", "contact"}) {
    StudyRequest r{kind};
    if (r.kind == "drift") r.steps = 100;
    SCOPED_TRACE(kind);
    const std::vector<Row> rows = measured(r);
    expect_eighty_columns(page_text(study_page(kind, rows, "x", rows.size())));
  }
}

// Of many curves the still picture has one a family and what is kept; the others are in the page's numbers.
TEST(Pages, ShowADozenOfManyCurves) {
  StudyRequest r{"convergence", {"short-A"}};
  r.coarsest = 10;
  r.rungs = 3;
  const std::vector<Row> rows = measured(r);
  const StudyPage page = study_page("convergence", rows, "x", rows.size());
  const auto& series = page.sections[0].plots[0].series;
  EXPECT_EQ(series.size(), 24u);
  EXPECT_EQ(std::count_if(series.begin(), series.end(), [](const report::Series& s) { return !s.aside; }), 11);
  const std::string picture = page_figures(page)[0], html = page_html(page);
  EXPECT_NE(picture.find(">rk4<"), std::string::npos);
  EXPECT_EQ(picture.find(">rkmk4<"), std::string::npos);
  EXPECT_NE(html.find("\"name\":\"rkmk4\""), std::string::npos);
  EXPECT_NE(html.find("13 more curves"), std::string::npos);
  r.methods = {"rkmk4", "rk4"};
  EXPECT_EQ(page_html(convergence_page(measured(r))).find("more curves"), std::string::npos);
}

// The orders of the standard study are those stated, where it prints one; to the two digits printed; but for one that comes to rounding before it
// settles, which docs/studies/README.md names.
TEST(Pages, PrintOrdersThatAreThoseStatedOrNone) {
  int seen = 0;
  const StudyPage page = convergence_page(measured({"convergence"}));
  for (const Section& section : page.sections)
    for (const std::vector<std::string>& line : named(section, "order, fitted").rows) {
      if (line[2] == "-" || line[2] == "floor") continue;
      ++seen;
      const double stated = std::stod(line[1]), fitted = std::stod(line[2]);
      if (section.heading == "case-A" && line[0] == "dormand-prince") {
        EXPECT_NEAR(fitted, 4.4, 0.1);
      } else {
        EXPECT_NEAR(fitted, stated, (stated >= 8 ? 0.5 : 0.3) + 0.005) << section.heading << " " << line[0];
      }
    }
  EXPECT_GT(seen, 60);
}

// A push of constant torque from rest is flown exactly by the closed form between kicks: what is left is rounding, and has no order.
TEST(Pages, PrintNoOrderOfRounding) {
  for (const char* problem : {"f-01", "f-03", "forced"}) {
    const Section section = convergence_page(measured({"convergence", {problem}})).sections[0];
    for (const std::vector<std::string>& line : named(section, "order, fitted").rows)
      for (int column = 2; column < 6; ++column) {
        const bool fitted = line[std::size_t(column)] != "-" && line[std::size_t(column)] != "floor";
        if (fitted) {
          EXPECT_GT(std::stod(line[std::size_t(column)]), 0.6) << problem << " " << line[0] << " column " << column;
        }
      }
    if (problem == std::string("f-01"))
      for (const std::vector<std::string>& line : named(section, "order, fitted").rows)
        if (line[0] == "exact") {
          EXPECT_EQ(line[2], "floor");
        }
  }
}

// Runs that failed are counted as such, not as too coarse.
TEST(Pages, CountRunsThatFailed) {
  std::vector<Row> rows;
  for (int k = 0; k < 6; ++k) {
    Row row{{"convergence", "short-A", "ode/step", 50L << k}, {}, k < 2 ? "ended without an answer" : "", ""};
    for (const char* name : {"attitude", "momentum", "energy", "position"}) row.put(name, k < 2 ? NAN : std::ldexp(0.01, -k));
    rows.push_back(row);
  }
  const StudyPage page = convergence_page(rows);
  const Table& fitted = named(page.sections[0], "order, fitted");
  EXPECT_EQ(fitted.header.back(), "failed");
  EXPECT_EQ(fitted.rows[0], (std::vector<std::string>{"ode/step", "-", "1.00", "1.00", "1.00", "1.00", "4", "0", "0", "2"}));
}

// What failed in the same words for both sums is said once.
TEST(Pages, SayOnceThatADriftFailed) {
  StudyRequest r{"drift", {"case-A"}, {"rk4"}};
  r.step = 1e30;
  r.steps = 10;
  const std::vector<Row> rows = measured(r);
  const std::string text = page_text(study_page("drift", rows, "x", rows.size()));
  const std::size_t at = text.find("left the numbers");
  ASSERT_NE(at, std::string::npos) << text;
  EXPECT_EQ(text.find("left the numbers", at + 1), std::string::npos) << text;
}

// A sweep with a value that failed has no worst error.
TEST(Pages, HaveNoWorstErrorOfASweepThatFailed) {
  std::vector<Row> rows;
  for (const double x : {0.0, 0.125, 0.25}) {
    Row row{{"contact", "p-04", "sheet", 120, 0, 0, x}, {}, x == 0.125 ? "left the numbers" : "", ""};
    row.put("error", x == 0.125 ? NAN : 0.01);
    rows.push_back(row);
  }
  EXPECT_EQ(contact_page(rows).sections[0].tables[0].rows[0][2], "-");
  EXPECT_NE(page_text(study_page("contact", rows, "x", rows.size())).find("left the numbers"), std::string::npos);
}

// Errors of four halved steps with log2 = -k + (a, -a, -a, a): the residuals have no slope, so the order is 1, and its interval of 95 % is
// t(2) sqrt(4 a^2 / 2 / 5) with t(2) = 4.303: 0.68 for a = 1/4. A run of 0.1 and more, one that failed, and those at rounding are counted, not fitted.
TEST(Pages, GiveAnOrderOfContactWithItsInterval) {
  std::vector<Row> rows;
  const auto add = [&](const char* method, long steps, double error) {
    rows.push_back({{"contact", "p-07", method, steps}, {}, std::isnan(error) ? "left the numbers" : "", ""});
    rows.back().put("error", error);
  };
  add("sheet", 60, NAN);
  add("sheet", 120, 0.5);
  for (int k = 0; k < 4; ++k) add("sheet", 240L << k, 0.01 * std::exp2(-k + (k == 0 || k == 3 ? 0.25 : -0.25)));
  for (int k = 0; k < 3; ++k) add("split2", 240L << k, 1e-16);
  add("located", 0, 1e-16);
  const Section section = contact_page(rows).sections[0];
  const Table& orders = named(section, "order of the error");
  EXPECT_EQ(orders.header, (std::vector<std::string>{"method", "order", "+-", "used", "coarse", "floor", "failed"}));
  ASSERT_EQ(orders.rows.size(), 2u);
  EXPECT_EQ(orders.rows[0], (std::vector<std::string>{"sheet", "1.00", "0.68", "4", "1", "0", "1"}));
  EXPECT_EQ(orders.rows[1], (std::vector<std::string>{"split2", "-", "-", "0", "0", "3", "0"}));
}

// Drift and stability fly on from a problem's start: neither its end nor the reference there is theirs.
TEST(Pages, NameAReferenceWhereOneIsUsed) {
  for (const char* kind : {"convergence", "drift", "stability"}) {
    const std::vector<std::string> text = problem_section({kind, "case-A", "rk4", 10}).text;
    const bool judged = kind == std::string("convergence");
    EXPECT_EQ(text[0].ends_with(", T = 10 s."), judged) << text[0];
    EXPECT_EQ(std::count_if(text.begin(), text.end(), [](const std::string& t) { return t.starts_with("Reference"); }), judged ? 1 : 0) << kind;
  }
}

// What is not swept has no place where its worst error lies.
TEST(Pages, NameNoPlaceWhereNothingIsSwept) {
  for (const ContactProblem& p : contact_problems()) {
    Row row{{"contact", p.name, "sheet", 120, 0, 0, p.sweep[0]}, {}, "", ""};
    row.put("error", 0.01);
    const Table t = contact_page({row}).sections[0].tables[0];
    EXPECT_EQ(t.header.size(), t.rows[0].size());
    for (const std::string& name : t.header) EXPECT_NE(name, "at");
    EXPECT_EQ(std::count(t.header.begin(), t.header.end(), "at " + p.x), p.sweep.size() > 1 ? 1 : 0) << p.name;
  }
}

// Of a student's steps the impacts are not counted, and the energy is nobody's ledger: no number is shown, not 0.
TEST(Pages, ShowNoCountOfWhatWasNotCounted) {
  std::vector<Row> rows;
  for (const char* method : {"sheet", "submission ada 0123"}) {
    Row row{{"contact", "p-07", method, 120}, {}, "", ""};
    const bool ours = method == std::string("sheet");
    row.put("error", 0.01);
    row.put("own_J", ours ? 0 : NAN);
    row.put("impacts", ours ? 0 : NAN);
    rows.push_back(row);
  }
  const Table t = contact_page(rows).sections[0].tables[0];
  const auto column = [&](const char* name) { return std::size_t(std::find(t.header.begin(), t.header.end(), name) - t.header.begin()); };
  for (const char* name : {"steps' own, J", "impacts"}) {
    EXPECT_EQ(t.rows[0][column(name)], "0");
    EXPECT_EQ(t.rows[1][column(name)], "-");
  }
}

// A way without steps has no step: it is not on the ladder's plot, and has no order.
TEST(Pages, GiveNoStepToAWayThatHasNone) {
  StudyRequest r{"convergence", {"short-A"}, {"rk4", "exact", "cvode-adams"}};
  r.coarsest = 10;
  r.rungs = 4;
  r.tolerances = {1e-6, 1e-9};
  const std::vector<Row> rows = measured(r);
  const Section s = convergence_page(rows).sections[0];
  ASSERT_EQ(s.plots.size(), 1u);
  ASSERT_EQ(s.plots[0].series.size(), 1u);
  EXPECT_EQ(s.plots[0].series[0].name, "rk4");
  EXPECT_EQ(named(s, "errors at the finest step").rows.size(), 1u);
  const Table without = named(s, "ways without a step");
  ASSERT_EQ(without.rows.size(), 3u);
  EXPECT_EQ(without.rows[0][1], "-");
  EXPECT_EQ(without.rows[1][1], "1e-06");
  EXPECT_EQ(without.rows[2][1], "1e-09");
  std::vector<Row> alone;
  for (const Row& row : rows)
    if (row.cell.method == "exact") alone.push_back(row);
  const Section closed = convergence_page(alone).sections[0];
  EXPECT_TRUE(closed.plots.empty());
  EXPECT_EQ(closed.tables.size(), 1u);
}

// Every error has its cheapest run, and a failed run is a row without numbers.
TEST(Pages, SayWhichMethodForWhichError) {
  const auto row = [](const char* method, double error, double time) {
    Row r{{"work-precision", "short-A", method, 1}, {}, std::isnan(error) ? "fell over" : "", ""};
    r.put("attitude", error);
    r.put("cpu_median", time);
    return r;
  };
  const std::vector<Row> rows{row("sheet", 1e-3, 2e-6), row("rk4", 1e-9, 5e-6), row("exact", 1e-16, 3e-6), row("ode/step", 1e-3, 1e-3), row("taylor16", std::nan(""), 1e-9)};
  const StudyPage page = work_page(rows);
  const Table& choices = page.sections[0].tables[0];
  EXPECT_EQ(choices.rows[0][1], "sheet (1 steps)");           // 1e-2
  EXPECT_EQ(choices.rows[0].back(), "500");                    // the peer's time over it
  EXPECT_EQ(choices.rows[3][1], "exact (1 steps)");            // 1e-5
  EXPECT_EQ(choices.rows[3][3], "rk4 (1 steps)");
  EXPECT_EQ(choices.rows[3][5], "none reaches it");
  const Table& costs = named(page.sections[0], "each method's cheapest");
  const auto dear = std::find_if(costs.rows.begin(), costs.rows.end(), [](const auto& line) { return line[0] == "ode/step"; });
  EXPECT_EQ((*dear)[4], "1000");  // microseconds a second of a problem of 1 s
  EXPECT_EQ((*dear)[5], "500");
  EXPECT_NE(page_markdown(study_page("work-precision", rows, "x", rows.size())).find("fell over"), std::string::npos);
}

}  // namespace
}  // namespace rigor::studies
