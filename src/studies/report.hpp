#pragma once
#include <rigor/report/plot.hpp>
#include <string>
#include <vector>

namespace rigor::studies {

struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t words = 1;  ///< so many columns on the left are words, the rest numbers
  bool every_run = false; ///< long: in the HTML alone
};
struct Section {
  std::string heading;
  std::vector<std::string> text;       ///< paragraphs
  std::vector<std::string> laws;       ///< ids of problems.tsv: MathML, or their plain text
  std::vector<std::string> givens;     ///< lines, set as they are
  std::vector<report::Plot> plots;
  std::vector<Table> tables;
};

/// A study's page, from which its HTML and its Markdown are made.
struct StudyPage {
  std::string title, lead;
  std::vector<Section> sections;
  std::string command;
  std::string unfinished{};  ///< "12 of 96 cells; interrupted": stands above everything; "" when nothing is missing
};

/// What a number was measured on: processor, cores, compiler and flags, versions of the libraries. One line each.
std::vector<std::string> machine();

/// One self-contained file, plots as static SVG.
std::string page_html(const StudyPage& page);
/// Markdown that shows figure-1.svg, figure-2.svg, ... beside it.
std::string page_markdown(const StudyPage& page);
std::vector<std::string> page_figures(const StudyPage& page);
/// Headings and tables for a terminal of 80 columns.
std::string page_text(const StudyPage& page);

}  // namespace rigor::studies
