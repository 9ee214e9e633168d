#pragma once
#include <string>
#include <vector>

namespace rigor::report {

/// One curve. Points that are not finite, or ≤ 0 on a logarithmic axis, are gaps: left out and counted in the
/// picture's text alternative.
struct Series {
  std::string name;
  std::vector<double> x, y;
  bool markers = true;
  bool dashed = false;  ///< a guide (a slope, a bound), not data
  int colour = -1;      ///< the number of the curve whose colour it shares; -1: one of its own
  bool aside = false;   ///< one too many for a still picture: not in it, to be switched on where the page has its script
};

struct Plot {
  std::string title;             ///< says what it shows; also the picture's text alternative
  std::string x_label, y_label;  ///< with units
  bool log_x = false, log_y = false;
  std::vector<Series> series;
};

/// A self-contained <figure> with one SVG: axes with ticks, curves with distinct colours and markers, a
/// legend, and a <title>/<desc> for screen readers. Static; readable in light, dark and print through the
/// page's colours.
std::string figure(const Plot& plot, const std::string& caption_html = "");

/// The bare SVG with its own colours, for Markdown pages.
std::string svg_file(const Plot& plot);

/// Bars with labels below, for histograms.
struct Bars {
  std::string title, x_label, y_label;
  std::vector<std::string> labels;
  std::vector<double> values;
};
std::string figure(const Bars& bars, const std::string& caption_html = "");

/// Tick positions inside [low, high]: decades on a logarithmic axis (every k-th when there are many), else
/// 1-2-5.
std::vector<double> ticks(double low, double high, bool logarithmic);

}  // namespace rigor::report
