#include "study/plot_svg.h"

#include <algorithm>
#include <cmath>

#include "study/html_page.h"

namespace hsr::internal {

namespace {

constexpr double width = 800, height = 440, left = 70, right = 500, top = 36, bottom = 370, zero_line = 392;
constexpr std::array<const char*, 20> colours = {"#3566c4", "#c4472b", "#2b8a57", "#8a4fbf", "#b07a10", "#15879b", "#b8397f",
                                                 "#6b6f76", "#7a8a1c", "#1f3f8f", "#8c2a1a", "#14532f", "#57308a", "#7a5406",
                                                 "#0b5563", "#7a1f52", "#4c7fb8", "#d2691e", "#5c8f3a", "#9a6a8f"};

std::string number(double x, int digits = 4) { return rounded_text(x, digits); }

std::string colour(std::size_t k) {
  k %= colours.size();
  return "var(--c" + std::to_string(k) + "," + colours[k] + ")";
}

std::string power_of_ten(double exponent) {
  if (exponent >= -3 && exponent <= 4) return number(std::pow(10, exponent), 6);
  return "1e" + std::to_string(static_cast<int>(exponent));
}

struct Tick {
  double share;
  std::string label;
};

/// Powers of ten around what is there, or the stops that were asked for.
struct Axis {
  double low = HUGE_VAL, high = -HUGE_VAL;
  std::vector<double> stops = {};

  void add(double x) {
    low = std::min(low, std::log10(x));
    high = std::max(high, std::log10(x));
  }
  void finish() {
    if (!(low <= high)) low = 0, high = 1;
    low = std::floor(low);
    high = std::max(std::ceil(high), low + 1);
  }
  /// 0 at its beginning, 1 at its end.
  double share(double x) const {
    if (stops.size() < 2) return (std::log10(x) - low) / (high - low);
    std::size_t k = 0;  // between the stops k and k + 1
    const bool ascends = stops.front() < stops.back();
    while (k + 2 < stops.size() && (ascends ? x > stops[k + 1] : x < stops[k + 1])) ++k;
    const double from = std::log10(stops[k]), part = (std::log10(x) - from) / (std::log10(stops[k + 1]) - from);
    return (static_cast<double>(k) + part) / static_cast<double>(stops.size() - 1);
  }
  /// So few that their labels do not touch.
  std::vector<Tick> ticks() const {
    std::vector<Tick> all;
    if (stops.size() < 2) {
      const double step = std::max(1.0, std::ceil((high - low) / 10));
      for (double e = low; e <= high + 0.5; e += step) all.push_back({(e - low) / (high - low), power_of_ten(e)});
      return all;
    }
    const std::size_t last = stops.size() - 1, stride = (last + 6) / 7;
    for (std::size_t k = 0; k<last; k = k + 2 * stride> last ? last : k + stride)  // the last one always, and room before it
      all.push_back({static_cast<double>(k) / static_cast<double>(last), short_text(stops[k])});
    all.push_back({1, short_text(stops[last])});
    return all;
  }
};

std::string mark(std::size_t shape, double x, double y, const std::string& colour, const std::string& tip) {
  const auto at = [&](double dx, double dy) { return number(x + dx) + "," + number(y + dy); };
  std::string element;
  switch (shape % 4) {
    case 0:
      element = "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"4\"";
      break;
    case 1:
      element = "<rect x=\"" + number(x - 3.5) + "\" y=\"" + number(y - 3.5) + "\" width=\"7\" height=\"7\"";
      break;
    case 2:
      element = "<polygon points=\"" + at(0, -4.5) + " " + at(4.5, 3.5) + " " + at(-4.5, 3.5) + "\"";
      break;
    default:
      element = "<polygon points=\"" + at(0, -5) + " " + at(5, 0) + " " + at(0, 5) + " " + at(-5, 0) + "\"";
  }
  return element + " fill=\"" + colour + "\"" +
         (tip.empty() ? "/>" : "><title>" + html_escaped(tip) + "</title></" + element.substr(1, element.find(' ') - 1) + ">");
}

std::string text(double x, double y, const std::string& words, const std::string& more = "") {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" fill=\"var(--ink,#222)\" " + more + ">" + html_escaped(words) +
         "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& stroke) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) +
         "\" stroke=\"" + stroke + "\"/>\n";
}

}  // namespace

std::string plot_svg(const Plot& plot) {
  Axis xs, ys;
  bool has_zero = false;
  const auto is_shown = [](const std::array<double, 2>& p) {
    return p[0] > 0 && p[1] >= 0 && std::isfinite(p[0]) && std::isfinite(p[1]);
  };
  for (const PlotSeries& s : plot.series)
    for (const auto& p : s.points) {
      if (!is_shown(p)) continue;
      xs.add(p[0]);
      if (p[1] > 0)
        ys.add(p[1]);
      else
        has_zero = true;
    }
  xs.finish();
  ys.finish();
  xs.stops = plot.stops;
  const auto x_at = [&](double x) { return left + xs.share(x) * (right - left); };
  const auto y_at = [&](double y) { return y > 0 ? bottom - ys.share(y) * (bottom - top) : zero_line; };

  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) + " " + number(height) +
                    "\" role=\"img\" aria-label=\"" + html_escaped(plot.title) +
                    "\" font-family=\"system-ui, sans-serif\" font-size=\"12\">\n";
  out += "<rect width=\"" + number(width) + "\" height=\"" + number(height) + "\" fill=\"var(--paper,#fff)\"/>\n";
  out += text(left, 20, plot.title, "font-size=\"14\" font-weight=\"600\"");
  for (const Tick& t : xs.ticks()) {
    const double x = left + t.share * (right - left);
    out += line(x, top, x, bottom, "var(--faint,#ddd)");
    out += text(x, has_zero ? 410 : 386, t.label, "text-anchor=\"middle\"");
  }
  for (const Tick& t : ys.ticks()) {
    const double y = bottom - t.share * (bottom - top);
    out += line(left, y, right, y, "var(--faint,#ddd)");
    out += text(left - 6, y + 4, t.label, "text-anchor=\"end\"");
  }
  if (has_zero) {
    out += line(left, zero_line, right, zero_line, "var(--ink,#222)");
    out += text(left - 6, zero_line + 4, plot.zero_label, "text-anchor=\"end\"");
  }
  out += text((left + right) / 2, has_zero ? 430 : 408, plot.x_label, "text-anchor=\"middle\"");
  out += text(0, 0, plot.y_label,
              "text-anchor=\"middle\" transform=\"translate(16 " + number((top + bottom) / 2) + ") rotate(-90)\"");

  double legend = top + 6;
  // As many lines as fit; a name that was there is not said twice.
  const auto names = static_cast<double>(
      std::count_if(plot.series.begin(), plot.series.end(), [](const PlotSeries& s) { return s.like < 0; }));
  const double legend_step = std::min(18.0, (height - 50) / std::max(names, 1.0));
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& s = plot.series[k];
    std::string path;
    for (const auto& p : s.points)
      if (is_shown(p))
        path.append(path.empty() ? "M" : "L").append(number(x_at(p[0]), 6)).append(" ").append(number(y_at(p[1]), 6));
    if (path.empty()) continue;
    const std::size_t shape = k / colours.size() + k;
    const std::string stroke = colour(s.like < 0 ? k : static_cast<std::size_t>(s.like));
    out.append("<path d=\"").append(path).append("\" fill=\"none\" stroke=\"").append(stroke).append("\" stroke-width=\"1.5\"");
    out.append(s.is_theory ? " stroke-dasharray=\"5 4\"" : "").append("/>\n");
    if (!s.is_theory)
      for (const auto& p : s.points)
        if (is_shown(p))
          out += mark(shape, x_at(p[0]), y_at(p[1]), stroke, s.name + ": " + number(p[0]) + ", " + number(p[1])) + "\n";
    if (s.like >= 0) continue;
    if (s.is_theory)
      out += "<path d=\"M512 " + number(legend) + "h18\" stroke=\"" + stroke +
             "\" stroke-dasharray=\"5 4\" stroke-width=\"1.5\"/>\n";
    else
      out += mark(shape, 521, legend, stroke, "") + "\n";
    out += text(536, legend + 4, s.name, legend_step < 13 ? "font-size=\"10\"" : "");
    legend += legend_step;
  }
  return out + "</svg>\n";
}

std::string plot_file(const Plot& plot) {
  const std::string svg = plot_svg(plot);
  std::string out;
  std::size_t at = 0;
  // "var(--name,colour)"
  for (std::size_t found = svg.find("var(--"); found != std::string::npos; found = svg.find("var(--", at)) {
    const std::size_t colour = svg.find(',', found) + 1, end = svg.find(')', colour);
    out.append(svg, at, found - at).append(svg, colour, end - colour);
    at = end + 1;
  }
  return out.append(svg, at);
}

}  // namespace hsr::internal
