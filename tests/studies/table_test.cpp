#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <reference/sundials.hpp>
#include <rigor/base/file.hpp>
#include <rigor/engine/exact_flight.hpp>
#include <rigor/linalg/rotation.hpp>
#include <rigor/studies/table.hpp>
#include <sstream>

namespace rigor::studies {
namespace {

using V = Vec3<double>;

std::string table(const std::string& name = "free-flight") { return *read_file(std::filesystem::path(RIGOR_SOURCE_DIR) / "reference/tables" / (name + ".csv")); }

struct Case {
  std::string id;
  V I, w;
  double t;
};
std::vector<Case> cases() {
  std::vector<Case> all;
  std::istringstream in(table());
  for (std::string line; std::getline(in, line);) {
    if (line.front() == '#' || line.rfind("case,", 0) == 0) continue;
    std::vector<std::string> c;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) c.push_back(cell);
    const auto x = [&](int i) { return std::stod(c[std::size_t(i)]); };
    all.push_back({c[0], V(x(2), x(3), x(4)), V(x(5), x(6), x(7)), x(8)});
  }
  return all;
}
template <class Answer>
std::string answers(Answer answer) {
  std::string csv = "wx,wy,wz,case,qw,qx,qy,qz\n";
  for (const Case& c : cases()) {
    const auto [R, w] = answer(c);
    const Vec4<double> q = quaternion_of<double>(R);
    char line[400];
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%s,%.17g,%.17g,%.17g,%.17g\n", w[0], w[1], w[2], c.id.c_str(), q[0], q[1], q[2], q[3]);
    csv += line;
  }
  return csv;
}

// The table against two methods that share nothing with the series it was made by: the closed form, which is good to
// rounding times the phase, and CVODE.
TEST(FreeFlightTable, AgreesWithTheClosedFormAndWithCvode) {
  const auto closed = check_table(table(), answers([](const Case& c) {
                                    const Attitude a = ExactFlight::make(c.I, c.w, identity3<double>())->at(c.t);
                                    return std::pair{a.R_WB, V(a.L_B.cwiseQuotient(c.I))};
                                  }), "closed");
  ASSERT_TRUE(closed) << closed.fault().text();
  std::fputs(table_text(*closed).c_str(), stdout);
  for (const TableRow& row : *closed) {
    EXPECT_EQ(row.answered, row.of);
    EXPECT_LT(row.attitude, row.stratum == "separatrix" ? 1e-11 : 1e-12) << row.stratum;
    EXPECT_LT(row.spin, row.stratum == "separatrix" ? 1e-11 : 1e-12) << row.stratum;
  }
  const auto cvode = check_table(table(), answers([](const Case& c) {
                                   const auto a = reference::cvode_free_body({c.I, c.w, identity3<double>()}, c.t, 1e-14);
                                   return std::pair{a->R_WB, a->w_B};
                                 }), "cvode");
  ASSERT_TRUE(cvode);
  for (const TableRow& row : *cvode) EXPECT_LT(row.attitude, 1e-9) << row.stratum;  // 1e-12 a second of fast turning
}

TEST(FreeFlightTable, FindsAWrongAnswerAndNamesWhatItCannotRead) {
  const std::string right = answers([](const Case& c) {
    const Attitude a = ExactFlight::make(c.I, c.w, identity3<double>())->at(c.t);
    return std::pair{a.R_WB, V(a.L_B.cwiseQuotient(c.I))};
  });
  const std::string wrong = answers([](const Case& c) {
    Attitude a = ExactFlight::make(c.I, c.w, identity3<double>())->at(c.t);
    if (c.id == "needle-2") a.R_WB = a.R_WB * exp_so3<double>(V(0, 1e-6, 0));
    return std::pair{a.R_WB, V(a.L_B.cwiseQuotient(c.I))};
  });
  const auto checked_wrong = check_table(table(), wrong, "x");
  ASSERT_TRUE(checked_wrong);
  for (const TableRow& row : *checked_wrong)
    if (row.stratum == "needle") {
      EXPECT_NEAR(row.attitude, 1e-6, 1e-9);
      EXPECT_EQ(row.worst, "needle-2");
    }
  const auto fault = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    const auto checked = check_table(table(), text, "mine.csv");
    return checked ? std::string("no fault") : checked.fault().text();
  };
  EXPECT_EQ(fault(right, "qw,", "a,"), "mine.csv has no column 'qw'; needed: case, qw, qx, qy, qz, wx, wy, wz");
  EXPECT_NE(fault(right, "generic-1,", "genric-1,").find("mine.csv:2 there is no case 'genric-1' (did you mean 'generic-1'?)"), std::string::npos) << fault(right, "generic-1,", "genric-1,");
  EXPECT_NE(fault(right, "generic-2,", "generic-1,").find("is there twice"), std::string::npos);
  EXPECT_NE(fault(right, "generic-1,", "generic-1,x").find("mine.csv:2, qw is 'x"), std::string::npos);
  EXPECT_NE(fault(right, "generic-1,", "generic-1,nan,").find("not finite"), std::string::npos);
  EXPECT_NE(fault(right, "generic-1,", "generic-1,3,").find("length"), std::string::npos);
  EXPECT_EQ(check_table(table(), "", "e").fault().kind, Fault::Kind::malformed);
  EXPECT_EQ(check_table(table(), "case,qw,qx,qy,qz,wx,wy,wz\n", "e").fault().kind, Fault::Kind::missing);
}

// Files as spreadsheets write them: a byte order mark is no part of the header, other separators and UTF-16 are named.
TEST(FreeFlightTable, KnowsAFileOfASpreadsheet) {
  const std::string right = table(), mark = "\xEF\xBB\xBF";
  const auto said = [&](const std::string& text) {
    const auto checked = check_table(right, text, "mine.csv");
    return checked ? verdict_text(verdict_of(*checked)) : checked.fault().text();
  };
  const std::string plain = said(right), header = right.substr(right.find("case,"));
  EXPECT_NE(plain.find("49 of 49"), std::string::npos) << plain;
  EXPECT_EQ(said(mark + right), plain);
  EXPECT_EQ(said(mark + header), plain);
  for (const auto& [separator, word] : {std::pair{';', "';'"}, {'\t', "tabs"}}) {
    std::string text = header;
    std::replace(text.begin(), text.end(), ',', separator);
    for (const std::string& file : {text, mark + text}) EXPECT_EQ(said(file), std::string("mine.csv has its columns separated by ") + word + ", must have ',' (and '.' in numbers)");
  }
  EXPECT_EQ(said(std::string("\xFF\xFE") + "c\0a\0"), "mine.csv is UTF-16, must be UTF-8");
}

// The JSON that is committed against the CSV that is, each read here by its own reader: value by value as text.
TEST(FrozenTables, AreTheSameAsJson) {
  for (const FrozenTable& frozen : frozen_tables()) {
    const std::string text = *read_file(std::filesystem::path(RIGOR_SOURCE_DIR) / "reference/tables" / (frozen.name + ".json")), csv = table(frozen.name);
    EXPECT_TRUE(text == table_json(frozen.name, csv)) << frozen.name << " is not what rigor check-table --write makes of the CSV";
    const auto json = nlohmann::json::parse(text);
    std::istringstream in(csv);
    std::vector<std::string> header, comments;
    std::size_t rows = 0;
    for (std::string line; std::getline(in, line);) {
      if (line.front() == '#') {
        comments.push_back(line.substr(2));
        continue;
      }
      std::vector<std::string> c;
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) c.push_back(cell);
      if (header.empty()) {
        header = c;
        continue;
      }
      const auto& row = json.at("cases").at(rows++);
      ASSERT_EQ(row.size(), header.size()) << line;
      for (std::size_t i = 0; i < header.size(); ++i) EXPECT_EQ(row.at(header[i]).get<std::string>(), c.at(i)) << c[0] << ", " << header[i];
    }
    EXPECT_EQ(json.at("cases").size(), rows);
    EXPECT_GE(rows, 24u);
    EXPECT_EQ(json.at("schema"), "rigor." + frozen.name + "-table/1");
    EXPECT_EQ(json.at("provenance").get<std::vector<std::string>>(), comments);
    EXPECT_EQ(json.at("command"), "rigor check-table --write DIR");
  }
}

// Made anew, the tables are those that are frozen, to the letter (minutes: only where everything is run).
TEST(FrozenTables, AreWhatTheirCommandMakes) {
  if (std::getenv("RIGOR_ALL") == nullptr) GTEST_SKIP() << "takes minutes; runs with ./rigor test --all";
  for (const FrozenTable& frozen : frozen_tables()) EXPECT_TRUE(frozen.make() == table(frozen.name)) << frozen.name;
}

}  // namespace
}  // namespace rigor::studies
