#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <rigor/report/html.hpp>
#include <rigor/report/plot.hpp>

namespace rigor::report {
namespace {

constexpr double width = 720, height = 430, left = 74, right = 14, top = 14, bottom = 52;

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// All ticks of an axis in one way: by exponent where a logarithmic one has a small or a large one.
std::vector<std::string> tick_texts(const std::vector<double>& ticks, bool logarithmic) {
  const bool by_exponent = logarithmic && std::any_of(ticks.begin(), ticks.end(), [](double t) { return t < 0.999e-3 || t >= 0.999e4; });
  std::vector<std::string> texts;
  for (const double t : ticks) texts.push_back(by_exponent ? "1e" + std::to_string(std::lround(std::log10(t))) : number("%g", t));
  return texts;
}

struct Axis {
  double low, high;
  bool logarithmic;
  double start, end;  // pixels

  double at(double value) const {
    const auto f = [&](double x) { return logarithmic ? std::log10(x) : x; };
    return start + (f(value) - f(low)) / (f(high) - f(low)) * (end - start);
  }
};

bool drawable(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

Axis axis_over(const std::vector<double>& values, bool logarithmic, double start, double end) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values)
    if (drawable(v, logarithmic)) low = std::min(low, v), high = std::max(high, v);
  if (!(low <= high)) low = logarithmic ? 0.1 : 0, high = 1;
  if (logarithmic) {
    low = std::pow(10, std::floor(std::log10(low) + 1e-9));
    high = std::pow(10, std::ceil(std::log10(high) - 1e-9));
    if (low == high) low /= 10, high *= 10;
  } else {
    const double size = std::max(std::abs(low), std::abs(high));
    const bool flat = high - low <= 1e-5 * size;  // ticks have six digits: what they cannot tell apart is drawn as a level line
    const double pad = flat ? std::max(1.0, size) / 2 : (high - low) * 0.04;
    low -= pad, high += pad;
  }
  return {low, high, logarithmic, start, end};
}

constexpr std::size_t colours_there_are = 8;

// Filled, or hollow where the colour is another curve's already.
std::string marker(std::size_t kind, double x, double y, const std::string& colour) {
  const std::string ink = "\" " + (kind / colours_there_are % 2 == 0 ? "fill=\"" + colour : "fill=\"none\" stroke-width=\"1.6\" stroke=\"" + colour) + "\"/>";
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> points) {
    std::string text = "<polygon points=\"";
    for (const auto& [dx, dy] : points) text += number("%.1f", x + dx) + "," + number("%.1f", y + dy) + " ";
    return text + ink;
  };
  switch (kind % 4) {
    case 0:
      return "<circle cx=\"" + number("%.1f", x) + "\" cy=\"" + number("%.1f", y) + "\" r=\"3.2" + ink;
    case 1:
      return polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
    case 2:
      return polygon({{0, -4}, {4, 3}, {-4, 3}});
    default:
      return polygon({{0, -4.3}, {4.3, 0}, {0, 4.3}, {-4.3, 0}});
  }
}

std::string frame(const Axis& x, const Axis& y, const Plot& plot) {
  std::string svg;
  const auto x_ticks = ticks(x.low, x.high, x.logarithmic), y_ticks = ticks(y.low, y.high, y.logarithmic);
  const auto x_texts = tick_texts(x_ticks, x.logarithmic), y_texts = tick_texts(y_ticks, y.logarithmic);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    const std::string at = number("%.1f", x.at(x_ticks[i]));
    svg += "<line class=\"grid\" x1=\"" + at + "\" x2=\"" + at + "\" y1=\"" + number("%g", top) + "\" y2=\"" +
           number("%g", height - bottom) + "\"/>";
    svg += "<text x=\"" + at + "\" y=\"" + number("%g", height - bottom + 17) + "\" text-anchor=\"middle\">" +
           x_texts[i] + "</text>";
  }
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    const std::string at = number("%.1f", y.at(y_ticks[i]));
    svg += "<line class=\"grid\" y1=\"" + at + "\" y2=\"" + at + "\" x1=\"" + number("%g", left) +
           "\" x2=\"" + number("%g", width - right) + "\"/>";
    svg += "<text y=\"" + number("%.1f", y.at(y_ticks[i]) + 4) + "\" x=\"" + number("%g", left - 6) +
           "\" text-anchor=\"end\">" + y_texts[i] + "</text>";
  }
  svg += "<rect class=\"axis\" fill=\"none\" x=\"" + number("%g", left) + "\" y=\"" + number("%g", top) +
         "\" width=\"" + number("%g", width - left - right) + "\" height=\"" +
         number("%g", height - top - bottom) + "\"/>";
  svg += "<text x=\"" + number("%g", (left + width - right) / 2) + "\" y=\"" + number("%g", height - 12) +
         "\" text-anchor=\"middle\">" + escape(plot.x_label) + "</text>";
  svg += "<text transform=\"translate(15 " + number("%g", (top + height - bottom) / 2) +
         ") rotate(-90)\" text-anchor=\"middle\">" + escape(plot.y_label) + "</text>";
  return svg;
}

// The number of a curve, by which it has its colour. Curves set aside count for themselves: the others have those of the still picture.
std::size_t number_of(const Plot& plot, std::size_t i) {
  const Series& s = plot.series[i];
  if (s.colour >= 0) return std::size_t(s.colour);
  return std::size_t(std::count_if(plot.series.begin(), plot.series.begin() + long(i), [&](const Series& before) { return before.aside == s.aside; }));
}
// Guides are dashed; so are, in long dashes, curves whose colour another one has already.
std::string dashes(const Series& s, std::size_t number) { return s.dashed ? "5 4" : number / colours_there_are % 2 == 1 ? "13 3" : ""; }
std::string dash_attribute(const std::string& pattern) { return pattern.empty() ? "" : " stroke-dasharray=\"" + pattern + "\""; }

std::string curve(const Series& s, std::size_t index, const Axis& x, const Axis& y,
                  const std::string& colour, const std::string& pattern) {
  std::string path, marks;
  bool pen_down = false;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    if (!drawable(s.x[i], x.logarithmic) || !drawable(s.y[i], y.logarithmic)) {
      pen_down = false;
      continue;
    }
    const double px = x.at(s.x[i]), py = y.at(s.y[i]);
    path += (pen_down ? "L" : "M") + number("%.1f", px) + " " + number("%.1f", py);
    pen_down = true;
    if (s.markers && !s.dashed)
      marks += "<g><title>" + escape(s.name) + ": " + number("%.6g", s.x[i]) + ", " + number("%.4g", s.y[i]) +
               "</title>" + marker(index, px, py, colour) + "</g>";
  }
  return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
         (s.dashed ? "1.2" : "1.8") + "\"" + dash_attribute(pattern) + "/>" + marks;
}

// How many points of a plot cannot be drawn: said in the text alternative, never silently dropped.
std::size_t gaps(const Plot& plot) {
  std::size_t count = 0;
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i)
      count += !drawable(s.x[i], plot.log_x) || !drawable(s.y[i], plot.log_y);
  return count;
}

std::string describe(const Plot& plot) {
  std::string text = plot.title + ". " + plot.x_label + " against " + plot.y_label + ". Curves:";
  for (const Series& s : plot.series) text += " " + s.name + ";";
  if (const std::size_t missing = gaps(plot))
    text += " " + std::to_string(missing) + " points are not finite or not positive and are not drawn.";
  return text;
}

std::string svg(Plot plot, const std::vector<std::string>& colours, const std::string& style) {
  std::erase_if(plot.series, [](const Series& s) { return s.aside; });
  std::vector<double> xs, ys;
  for (const Series& s : plot.series) {
    xs.insert(xs.end(), s.x.begin(), s.x.end());
    ys.insert(ys.end(), s.y.begin(), s.y.end());
  }
  const Axis x = axis_over(xs, plot.log_x, left, width - right),
             y = axis_over(ys, plot.log_y, height - bottom, top);
  const std::size_t rows = (plot.series.size() + 2) / 3;
  const double total = height + 20.0 * double(rows) + 6;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " +
                    number("%g", width) + " " + number("%g", total) + "\" width=\"" + number("%g", width) +
                    "\" height=\"" + number("%g", total) + "\"><title>" + escape(plot.title) +
                    "</title><desc>" + escape(describe(plot)) + "</desc>" + style + frame(x, y, plot);
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    out += curve(plot.series[i], i, x, y, colours[number_of(plot, i) % colours_there_are], dashes(plot.series[i], number_of(plot, i)));
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const double px = left + double(i % 3) * (width - left - right) / 3,
                 py = height + 8 + 20.0 * double(i / 3);
    const std::string& colour = colours[number_of(plot, i) % colours_there_are];
    out += "<line x1=\"" + number("%g", px) + "\" x2=\"" + number("%g", px + 22) + "\" y1=\"" +
           number("%g", py) + "\" y2=\"" + number("%g", py) + "\" stroke=\"" + colour +
           "\" stroke-width=\"2\"" + dash_attribute(dashes(plot.series[i], number_of(plot, i))) + "/>";
    if (plot.series[i].markers && !plot.series[i].dashed) out += marker(i, px + 11, py, colour);
    out += "<text x=\"" + number("%g", px + 28) + "\" y=\"" + number("%g", py + 4) + "\">" +
           escape(plot.series[i].name) + "</text>";
  }
  return out + "</svg>";
}

const std::vector<std::string> page_colours{"var(--s0)", "var(--s1)", "var(--s2)", "var(--s3)",
                                            "var(--s4)", "var(--s5)", "var(--s6)", "var(--s7)"};
const std::vector<std::string> file_colours{"#0b5cad", "#b3420a", "#1a7a3c", "#7b3fb5",
                                            "#8a6100", "#0a7480", "#a3195b", "#555"};

// The numbers of a plot, for src/view/web/hover.js; what cannot be drawn is null.
std::string data(const Plot& plot) {
  nlohmann::ordered_json json{{"x_label", plot.x_label}, {"y_label", plot.y_label}, {"log_x", plot.log_x}, {"log_y", plot.log_y}};
  for (const Series& s : plot.series) {
    nlohmann::ordered_json x = nlohmann::ordered_json::array(), y = x;
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
      if (!drawable(s.x[i], plot.log_x)) continue;
      x.push_back(std::strtod(number("%.7g", s.x[i]).c_str(), nullptr));  // more digits than a pixel shows only make the page larger
      if (drawable(s.y[i], plot.log_y)) y.push_back(std::strtod(number("%.5g", s.y[i]).c_str(), nullptr));
      else y.push_back(nullptr);
    }
    const std::size_t place = number_of(plot, std::size_t(&s - plot.series.data()));
    json["series"].push_back({{"name", s.name}, {"x", x}, {"y", y}, {"markers", s.markers}, {"dashed", s.dashed}, {"aside", s.aside}, {"colour", place % colours_there_are}, {"dash", dashes(s, place)}});
  }
  std::string text;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    if (c == '<') text += "\\u003c";  // no end tag can begin inside the data
    else text += c;
  return "<script type=\"application/json\">" + text + "</script>";
}

std::string in_figure(const std::string& picture, const std::string& caption_html) {
  return "<figure>" + picture +
         (caption_html.empty() ? "" : "<figcaption>" + caption_html + "</figcaption>") + "</figure>\n";
}

}  // namespace

std::vector<double> ticks(double low, double high, bool logarithmic) {
  std::vector<double> at;
  if (logarithmic) {
    const int first = int(std::ceil(std::log10(low) - 1e-9)), last = int(std::floor(std::log10(high) + 1e-9));
    const int every = std::max(1, (last - first + 9) / 10);
    for (int e = first; e <= last; e += every) at.push_back(std::pow(10, e));
    return at;
  }
  const double raw = (high - low) / 7, power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double multiple : {5.0, 2.0, 1.0})
    if (multiple * power >= raw) step = multiple * power;
  const double first = std::ceil(low / step);
  for (int k = 0; k < 16 && (first + k) * step <= high; ++k) at.push_back((first + k) * step + 0.0);  // + 0.0: no negative zero
  return at;
}

std::string figure(const Plot& plot, const std::string& caption_html) {
  return "<figure class=\"plot\">" + svg(plot, page_colours, "") + data(plot) +
         (caption_html.empty() ? "" : "<figcaption>" + caption_html + "</figcaption>") + "</figure>\n";
}

std::string svg_file(const Plot& plot) {
  return svg(plot, file_colours,
             "<style>text{font:12px "
             "sans-serif;fill:#1b1f24}.grid{stroke:#d0d7de}.axis{stroke:#57606a}</style>"
             "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>") +
         "\n";
}

std::string figure(const Bars& bars, const std::string& caption_html) {
  const Axis y = axis_over(
      [&] {
        auto v = bars.values;
        v.push_back(0);
        return v;
      }(),
      false, height - bottom, top);
  const Axis from_zero{0, y.high, false, y.start, y.end};
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 " +
                    number("%g", width) + " " + number("%g", height) + "\" width=\"" + number("%g", width) +
                    "\" height=\"" + number("%g", height) + "\"><title>" + escape(bars.title) +
                    "</title><desc>";
  for (std::size_t i = 0; i < bars.values.size(); ++i)
    out += escape(bars.labels[i]) + ": " + number("%g", bars.values[i]) + "; ";
  out += "</desc>";
  for (const double v : ticks(0, from_zero.high, false)) {
    if (v != std::floor(v)) continue;  // bars count
    const std::string at = number("%.1f", from_zero.at(v));
    out += "<line class=\"grid\" y1=\"" + at + "\" y2=\"" + at + "\" x1=\"" + number("%g", left) +
           "\" x2=\"" + number("%g", width - right) + "\"/><text y=\"" + number("%.1f", from_zero.at(v) + 4) +
           "\" x=\"" + number("%g", left - 6) + "\" text-anchor=\"end\">" + number("%g", v) + "</text>";
  }
  const double pitch = (width - left - right) / double(std::max<std::size_t>(1, bars.values.size()));
  for (std::size_t i = 0; i < bars.values.size(); ++i) {
    const double x = left + pitch * double(i), y_top = from_zero.at(bars.values[i]);
    out += "<g><title>" + escape(bars.labels[i]) + ": " + number("%g", bars.values[i]) +
           "</title><rect fill=\"var(--s0)\" x=\"" + number("%.1f", x + pitch * 0.12) + "\" y=\"" +
           number("%.1f", y_top) + "\" width=\"" + number("%.1f", pitch * 0.76) + "\" height=\"" +
           number("%.1f", height - bottom - y_top) + "\"/></g><text x=\"" + number("%.1f", x + pitch / 2) +
           "\" y=\"" + number("%g", height - bottom + 17) + "\" text-anchor=\"middle\">" +
           escape(bars.labels[i]) + "</text>";
  }
  out += "<text x=\"" + number("%g", (left + width - right) / 2) + "\" y=\"" + number("%g", height - 12) +
         "\" text-anchor=\"middle\">" + escape(bars.x_label) + "</text>" + "<text transform=\"translate(15 " +
         number("%g", (top + height - bottom) / 2) + ") rotate(-90)\" text-anchor=\"middle\">" +
         escape(bars.y_label) + "</text></svg>";
  return in_figure(out, caption_html);
}

}  // namespace rigor::report
