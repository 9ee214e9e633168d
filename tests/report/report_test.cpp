#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <regex>
#include <set>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>

namespace rigor::report {
namespace {

TEST(Escape, LeavesNothingThatABrowserOrATerminalWouldInterpret) {
  EXPECT_EQ(escape("<b a=\"1\" b='2'>&"), "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(escape("a\x1b[31mb"), "a\xEF\xBF\xBD[31mb");
  EXPECT_EQ(escape("\xC3\xBC \xE2\x84\x9A"), "\xC3\xBC \xE2\x84\x9A");  // ü ℚ stay
  EXPECT_EQ(escape("\xC0\xBC"), "\xEF\xBF\xBD\xEF\xBF\xBD");            // an overlong '<' does not
}

TEST(Escape, OfRandomBytesHasNoMarkupAndNoControlCharacters) {
  std::mt19937 random(7);
  for (int k = 0; k < 20000; ++k) {
    std::string bytes(random() % 24, '\0');
    for (char& c : bytes) c = char(random());
    const std::string safe = escape(bytes);
    EXPECT_EQ(safe.find_first_of("<>\"'"), std::string::npos);
    for (const char c : safe) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
  }
}

TEST(Page, EscapesItsTitleAndForbidsEveryLoad) {
  Page page;
  page.title = "<script>alert(1)</script>";
  const std::string html = render(page);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(html.find("script-src 'none'"), std::string::npos);
}

TEST(Ticks, AreDecadesOnALogarithmicAxisAndOneTwoFiveElse) {
  EXPECT_EQ(ticks(1e-3, 1e1, true).size(), 5u);
  EXPECT_LE(ticks(1e-16, 1e3, true).size(), 11u);
  EXPECT_EQ(ticks(0, 10, false), (std::vector<double>{0, 2, 4, 6, 8, 10}));
}

// An energy that is kept but for roundings: a level line, and an end to its ticks.
TEST(Plot, OfANumberThatChangesByRoundingsHasAnEnd) {
  const double x = 254.546;
  const Plot plot{"energy", "time", "energy", false, false, {{"a", {0, 1, 2}, {x, std::nextafter(x, 0), std::nextafter(x, 999)}}}};
  const std::string svg = svg_file(plot);
  EXPECT_LT(svg.size(), 10000u);
  EXPECT_NE(svg.find(">250<"), std::string::npos) << svg;
  EXPECT_LE(ticks(x, std::nextafter(x, 999), false).size(), 16u);
}

// A curve set aside is not in the still picture, nor in its axes and legend; its numbers are in the page.
TEST(Plot, LeavesOutWhatIsSetAside) {
  Plot plot{"error", "step", "error", true, true, {{"a", {1, 2}, {1e-3, 1e-2}}, {"b", {1, 2}, {1e-9, 1e-8}}}};
  EXPECT_NE(svg_file(plot).find(">1e-9<"), std::string::npos);
  plot.series[1].aside = true;
  for (const char* of_b : {">1e-9<", ">b<", "b;"}) EXPECT_EQ(svg_file(plot).find(of_b), std::string::npos) << of_b;
  EXPECT_NE(figure(plot).find("\"name\":\"b\""), std::string::npos);
  plot.series.push_back({"c", {1, 2}, {1e-3, 1e-2}});  // of the colour that it has in the still picture, the second
  EXPECT_NE(figure(plot).find("\"aside\":false,\"colour\":1,\"dash\":\"\"}]"), std::string::npos) << figure(plot);
}

// Sixteen curves are told apart: no two lines of the legend are drawn alike, and of curves that are one point each no two markers.
TEST(Plot, DrawsNoTwoOfSixteenCurvesAlike) {
  Plot plot{"error", "step", "error", true, true, {}};
  for (char c = 'a'; c <= 'p'; ++c) plot.series.push_back({std::string(1, c), {1}, {1e-3}});
  const std::string svg = svg_file(plot);
  const auto different = [&](const std::regex& drawn) {
    std::set<std::string> ways;
    for (std::sregex_iterator it(svg.begin(), svg.end(), drawn), end; it != end; ++it) ways.insert((*it)[1]);
    return ways.size();
  };
  EXPECT_EQ(different(std::regex("<line x1=[^>]* (stroke=[^>]*)/>")), 16u);
  EXPECT_EQ(different(std::regex("<g><title>[^<]*</title><(?:circle|polygon) ([^>]*)/></g>")), 16u);  // at one place, so what differs is shape and ink
}

TEST(Plot, SaysHowManyPointsItCannotDraw) {
  Plot plot{"error", "step", "error", true, true, {{"a", {1, 2, 4}, {1e-3, NAN, 0}}}};
  const std::string html = figure(plot);
  EXPECT_NE(html.find("2 points are not finite or not positive"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace rigor::report
