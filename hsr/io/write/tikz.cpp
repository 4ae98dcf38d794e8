#include "hsr/io/write/tikz.h"

#include <algorithm>
#include <cmath>

#include "hsr/io/write/dashes.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

std::string name_of(const FillLine& line) { return Layer{false, line.edge_class, {}, {}}.name(); }

std::string length(double mm) {
  std::string out;
  append_length(out, mm);
  return out;
}

/// A document around the picture, unless there is one.
std::string document_start(const Drawing& drawing) {
  const std::string size = "\\paperwidth=" + length(drawing.width) + "mm \\paperheight=" + length(drawing.height) + "mm\n";
  return R"(% Run pdflatex on this file, or \input it into a document that has \usepackage{tikz}.
% Styles by name, such as "hsr visible outline", may be set before: \tikzset{hsr visible outline/.style={line width=1pt}}
\def\hsrbegin{}\def\hsrend{}
\ifx\tikzpicture\undefined
\documentclass{article}
\usepackage{tikz}
\pagestyle{empty}
)" + size +
         R"(\pdfpagewidth=\paperwidth \pdfpageheight=\paperheight
\hoffset=-1in \voffset=-1in \textwidth=\paperwidth \textheight=\paperheight
\oddsidemargin=0pt \topmargin=0pt \headheight=0pt \headsep=0pt \topskip=0pt \parindent=0pt \maxdepth=0pt
\def\hsrbegin{\begin{document}\noindent}\def\hsrend{\end{document}}
\fi
\def\hsrstyle#1#2{\pgfkeysifdefined{/tikz/hsr #1/.@cmd}{}{\tikzset{hsr #1/.style={#2}}}}
)";
}

void append_dashes(std::string& out, std::span<const double> lengths) {
  out += "dash pattern=";
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    out += k == 0 ? "on " : k % 2 == 0 ? " on " : " off ";
    append_rounded_length(out, lengths[k]);
    out += "mm";
  }
}

void append_style(std::string& out, const Layer& layer) {
  const Pen& pen = layer.pen;
  out += "\\hsrstyle{" + layer.name() + "}{line width=" + length(pen.width) + "mm, line join=round, line cap=";
  out += pen.is_dashed() ? "butt" : "round";
  if (pen.has_colour) {
    out += ", draw={rgb,255:red," + std::to_string(pen.colour[0]) + ";green," + std::to_string(pen.colour[1]) + ";blue," +
           std::to_string(pen.colour[2]) + "}";
  }
  if (pen.is_dashed()) {
    out += ", ";
    append_dashes(out, pen.dashes);
  }
  out += "}\n";
}

void append_point(std::string& out, const PaperPoint& p) {
  out += '(';
  append_coordinate(out, p.x);
  out += ',';
  append_coordinate(out, p.y);
  out += ')';
}

void append_path(std::string& out, std::span<const PaperPoint> points, bool closed) {
  const char* between = "";
  for (const PaperPoint& p : points) {
    out += between;
    between = "\n--";
    append_point(out, p);
  }
  if (closed) out += "\n--cycle";
}

void append_path(std::string& out, const Path& path, double tolerance) {
  const char* between = "";
  const auto point = [&](const PaperPoint& p) {
    out += between;
    between = "\n--";
    append_point(out, p);
  };
  const auto control = [&](const char* word, const Point2& p) {
    out += word;
    append_rounded_length(out, p.x);
    out += ',';
    append_rounded_length(out, p.y);
  };
  for_each_part(path, point, point, [&](const PathPart& arc) {
    for (const Bezier& curve : beziers(arc, tolerance)) {
      control("\n..controls (", curve.first);
      control(") and (", curve.second);
      between = ")..";
      point(curve.to);
    }
  });
  if (path.closed) out += "\n--cycle";
}

void append_line(std::string& out, const Drawing& drawing, const Polyline& p, const Pen& pen) {
  out += "\\draw";
  if (!pen.is_dashed()) {
    out += ' ';
    append_path(out, path_of(drawing, p), drawing.arc_tolerance);
  } else {
    const DashedPath dashed = dashed_path(path_of(drawing, p), pen);
    out += '[';
    if (dashed.lengths.size() == 1)
      out += "solid";
    else
      append_dashes(out, dashed.lengths);
    out += "] ";
    append_path(out, dashed.path, drawing.arc_tolerance);
  }
  out += ";\n";
}

void append_fills(std::string& out, const Fills& fills) {
  if (fills.fills.empty()) return;
  out += "\\begin{scope}[hsr fill]\n";
  for_each_painted(
      fills,
      [&](std::span<const Fill> sheet) {
        out += "\\begin{scope}[transparency group, opacity=" + length(std::round(sheet[0].opacity * 1000) / 1000) + "]\n";
      },
      [&](const Fill& fill, double opacity) {
        out += "\\definecolor{hsr fill}{RGB}{";
        for (std::size_t k = 0; k < 3; ++k) out += (k == 0 ? "" : ",") + std::to_string(fill.colour[k]);
        out += "}\\path[fill=hsr fill";
        if (opacity < 1) out += ", fill opacity=" + length(std::round(opacity * 1000) / 1000);
        out += "] ";
        for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r)
          if (!fills.rings[r].empty()) append_path(out, fills.rings[r], true);
        out += ";\n";
      },
      [&] { out += "\\end{scope}\n"; },
      [&](const FillLine& line) {
        out += "\\draw[hsr " + name_of(line) + "] ";
        append_path(out, fills.points_of(line), line.closed);
        out += ";\n";
      });
  out += "\\end{scope}\n";
}

/// The layers, and those that the lines between fills would be in.
std::vector<Layer> styled_layers(const Drawing& drawing, const std::vector<Layer>& layers) {
  std::vector<Layer> all = layers;
  for (const FillLine& line : drawing.fills.lines)
    if (std::none_of(all.begin(), all.end(), [&](const Layer& l) { return l.name() == name_of(line); }))
      all.push_back({false, line.edge_class, drawing.pens.of(false, line.edge_class), {}});
  return all;
}

}  // namespace

std::string tikz(const Drawing& drawing) {
  const std::vector<Layer> layers = layers_of(drawing);
  std::string out = document_start(drawing);
  out += "\\hsrstyle{fill}{}\n";
  for (const Layer& layer : styled_layers(drawing, layers)) append_style(out, layer);
  out += "\\hsrbegin\n\\begin{tikzpicture}[x=1mm,y=-1mm]\n\\useasboundingbox (0,0) rectangle (" + length(drawing.width) + "," +
         length(drawing.height) + ");\n";
  append_fills(out, drawing.fills);
  for (const Layer& layer : layers) {
    out += "\\begin{scope}[hsr " + layer.name() + "]\n";
    ObjectComments objects(drawing.objects);
    for (const Polyline& p : layer.polylines) {
      objects.append(out, p.object);
      append_line(out, drawing, p, layer.pen);
    }
    out += "\\end{scope}\n";
  }
  return out + "\\end{tikzpicture}%\n\\hsrend\n";
}

}  // namespace hsr::internal
