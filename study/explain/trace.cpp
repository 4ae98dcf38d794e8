#include "study/explain/trace.h"

#include <cmath>

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"
#include "study/html_page.h"

namespace hsr::internal {

namespace {

void append_key(std::string& out, const char* key) {
  if (out.back() != '{') out += ',';
  append_string(out, key);
  out += ':';
}

/// JSON has no infinities; a place has as many digits as a picture needs.
void append_place(std::string& out, double x) { append_number(out, std::round(x * 1000) / 1000 + 0.0, Numbers::rounded); }

void append_finite(std::string& out, double x) {
  if (std::isfinite(x))
    append_number(out, x, Numbers::rounded);
  else
    append_string(out, x > 0 ? "infinite" : x < 0 ? "-infinite" : "none");
}

template <class List, class Append>
void append_list(std::string& out, const List& list, const Append& append) {
  out += '[';
  bool is_first = true;
  for (const auto& item : list) {
    if (!is_first) out += ',';
    is_first = false;
    append(item);
  }
  out += ']';
}

void append_place(std::string& out, const TracePlace& p) {
  out += '[';
  append_place(out, p[0]);
  out += ',';
  append_place(out, p[1]);
  out += ']';
}

void append_ring(std::string& out, const TraceRing& ring) {
  append_list(out, ring, [&](const TracePlace& p) { append_place(out, p); });
}

void append_line(std::string& out, const TraceLine& line) {
  out += '[';
  append_place(out, line.from);
  out += ',';
  append_place(out, line.to);
  out += line.is_hidden ? ",true]" : "]";
}

void append_item(std::string& out, const TraceItem& item) {
  out += '[';
  append_string(out, item.text);
  out += ',' + std::to_string(item.face) + ']';
}

void append_numbers(std::string& out, const char* key, const std::vector<std::uint32_t>& list) {
  if (list.empty()) return;
  append_key(out, key);
  append_list(out, list, [&](std::uint32_t x) { append_integer(out, x); });
}

}  // namespace

std::string trace_text(double x) {
  if (std::isinf(x)) return x > 0 ? "∞" : "−∞";
  const double size = std::fabs(x);
  if (size < 1e9 && (size >= 1e4 || x == std::round(x))) return rounded_text(std::round(x) + 0.0, 9);
  return rounded_text(x + 0.0, 4);
}

TraceStep& TraceStep::number(const std::string& name, double value) {
  numbers_.emplace_back(name, value);
  return *this;
}

TraceStep& TraceStep::number(const std::string& name, const std::string& value) {
  numbers_.emplace_back(name, value);
  return *this;
}

TraceStep& TraceStep::face(std::uint32_t face) {
  faces_.push_back(face);
  return *this;
}

TraceStep& TraceStep::piece(std::uint32_t piece) {
  pieces_.push_back(piece);
  return *this;
}

TraceStep& TraceStep::edge(std::uint32_t edge) {
  edges_.push_back(edge);
  return *this;
}

TraceStep& TraceStep::mark(const TraceLine& line) {
  marks_.push_back(line);
  return *this;
}

TraceStep& TraceStep::row(int row) {
  row_ = row;
  return *this;
}

TraceStep& TraceStep::tile(const TraceTile& tile) {
  tiles_.push_back(tile);
  return *this;
}

std::string& TraceStep::change(const char* what) {
  if (!changes_.empty()) changes_ += ',';
  changes_ += "{";
  append_key(changes_, "do");
  append_string(changes_, what);
  return changes_;
}

TraceStep& TraceStep::list(const std::string& name, const std::vector<TraceItem>& items) {
  std::string& out = change("list");
  append_key(out, "name");
  append_string(out, name);
  append_key(out, "items");
  append_list(out, items, [&](const TraceItem& item) { append_item(out, item); });
  end_change();
  return *this;
}

TraceStep& TraceStep::add(const std::string& list, const TraceItem& item) {
  std::string& out = change("add");
  append_key(out, "name");
  append_string(out, list);
  append_key(out, "item");
  append_item(out, item);
  end_change();
  return *this;
}

TraceStep& TraceStep::make_piece(std::uint32_t piece, std::uint32_t face, const std::string& name, const TraceRing& ring) {
  std::string& out = change("piece");
  append_key(out, "piece");
  append_integer(out, piece);
  append_key(out, "face");
  append_integer(out, face);
  append_key(out, "name");
  append_string(out, name);
  append_key(out, "ring");
  append_ring(out, ring);
  end_change();
  return *this;
}

TraceStep& TraceStep::drop(std::uint32_t piece) {
  std::string& out = change("drop");
  append_key(out, "piece");
  append_integer(out, piece);
  end_change();
  return *this;
}

TraceStep& TraceStep::paint(std::uint32_t piece) {
  std::string& out = change("paint");
  append_key(out, "piece");
  append_integer(out, piece);
  end_change();
  return *this;
}

TraceStep& TraceStep::unpaint() {
  change("unpaint");
  end_change();
  return *this;
}

TraceStep& TraceStep::undraw() {
  change("undraw");
  end_change();
  return *this;
}

TraceStep& TraceStep::cells(const std::vector<TraceCell>& cells) {
  std::string& out = change("cells");
  append_key(out, "cells");
  append_list(out, cells, [&](const TraceCell& c) {
    out += '[' + std::to_string(c.column) + ',' + std::to_string(c.row) + ',';
    append_string(out, c.text);
    out += ',' + std::to_string(c.face);
    if (c.colour) {
      out += ",\"";
      append_colour(out, *c.colour);
      out += '"';
    }
    out += ']';
  });
  end_change();
  return *this;
}

TraceStep& TraceStep::tiles(const TraceTiles& tiles) {
  std::string& out = change("tiles");
  append_key(out, "corner");
  append_place(out, tiles.corner);
  append_key(out, "column");
  append_place(out, tiles.column);
  append_key(out, "row");
  append_place(out, tiles.row);
  append_key(out, "columns");
  out += std::to_string(tiles.columns);
  append_key(out, "rows");
  out += std::to_string(tiles.rows);
  append_key(out, "depths");
  append_list(out, tiles.depths, [&](double x) { out += std::isfinite(x) ? rounded_text(x + 0.0, 4) : "null"; });
  end_change();
  return *this;
}

TraceStep& TraceStep::masks(const std::string& name, const std::vector<TraceMask>& masks) {
  std::string& out = change("masks");
  append_key(out, "name");
  append_string(out, name);
  append_key(out, "masks");
  append_list(out, masks, [&](const TraceMask& m) {
    out += '[';
    append_string(out, m.text);
    out += ',' + std::to_string(m.face) + ',';
    append_list(out, m.rows, [&](const std::string& row) { append_string(out, row); });
    out += ']';
  });
  end_change();
  return *this;
}

TraceStep& TraceStep::node(std::uint32_t node, int parent, bool is_before, const std::string& text, int face) {
  std::string& out = change("node");
  append_key(out, "node");
  append_integer(out, node);
  append_key(out, "parent");
  out += std::to_string(parent);
  append_key(out, "side");
  append_string(out, is_before ? "in front" : "behind");
  append_key(out, "text");
  append_string(out, text);
  append_key(out, "face");
  out += std::to_string(face);
  end_change();
  return *this;
}

TraceStep& TraceStep::bars(const std::string& name, const std::vector<TraceBar>& bars) {
  std::string& out = change("bars");
  append_key(out, "name");
  append_string(out, name);
  append_key(out, "bars");
  append_list(out, bars, [&](const TraceBar& b) {
    out += '[';
    append_finite(out, b.from);
    out += ',';
    append_finite(out, b.to);
    out += ',' + std::to_string(b.face) + ']';
  });
  end_change();
  return *this;
}

TraceStep& TraceStep::draw(const std::vector<TraceLine>& lines) {
  std::string& out = change("draw");
  append_key(out, "lines");
  append_list(out, lines, [&](const TraceLine& line) { append_line(out, line); });
  end_change();
  return *this;
}

TraceStep& TraceStep::ask(TraceQuestion question) {
  question_ = std::move(question);
  return *this;
}

void TraceStep::append_to(std::string& out) const {
  out += '{';
  append_key(out, "kind");
  append_string(out, kind_);
  append_key(out, "line");
  append_string(out, line_);
  append_key(out, "says");
  append_string(out, says_);
  if (!numbers_.empty()) {
    append_key(out, "numbers");
    append_list(out, numbers_, [&](const auto& n) {
      out += '[';
      append_string(out, n.first);
      out += ',';
      if (const auto* const x = std::get_if<double>(&n.second))
        append_finite(out, *x);
      else
        append_string(out, std::get<std::string>(n.second));
      out += ']';
    });
  }
  append_numbers(out, "faces", faces_);
  append_numbers(out, "pieces", pieces_);
  append_numbers(out, "edges", edges_);
  if (!marks_.empty()) {
    append_key(out, "marks");
    append_list(out, marks_, [&](const TraceLine& line) { append_line(out, line); });
  }
  if (row_ >= 0) {
    append_key(out, "row");
    out += std::to_string(row_);
  }
  if (!tiles_.empty()) {
    append_key(out, "tiles");
    append_list(out, tiles_, [&](const TraceTile& t) {
      out += '[' + std::to_string(t.column) + ',' + std::to_string(t.row) + (t.hides ? ",true]" : ",false]");
    });
  }
  if (!changes_.empty()) {
    append_key(out, "changes");
    out += '[' + changes_ + ']';
  }
  if (asks()) {
    append_key(out, "question");
    append_string(out, question_.question);
    append_key(out, "choices");
    append_list(out, question_.choices, [&](const std::string& c) { append_string(out, c); });
    append_key(out, "right");
    append_integer(out, question_.right);
  }
  out += '}';
}

namespace {

void append_scene(std::string& out, const TracedScene& scene) {
  out += '{';
  append_key(out, "width");
  append_place(out, scene.width);
  append_key(out, "height");
  append_place(out, scene.height);
  append_key(out, "samples");
  out += scene.has_samples ? "true" : "false";
  append_key(out, "faces");
  append_list(out, scene.faces, [&](const TracedFace& f) {
    out += '{';
    append_key(out, "name");
    append_string(out, f.name);
    append_key(out, "colour");
    out += '"';
    append_colour(out, f.colour);
    out += '"';
    append_key(out, "rings");
    append_list(out, f.rings, [&](const TraceRing& ring) { append_ring(out, ring); });
    out += '}';
  });
  append_key(out, "edges");
  append_list(out, scene.edges, [&](const TracedEdge& e) {
    out += '{';
    append_key(out, "name");
    append_string(out, e.name);
    append_key(out, "from");
    append_place(out, e.from);
    append_key(out, "to");
    append_place(out, e.to);
    out += '}';
  });
  out += '}';
}

void append_pseudocode(std::string& out, std::string_view lines) {
  out += '[';
  bool is_first = true;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    const std::size_t bar = line.find('|');
    if (bar == std::string_view::npos) continue;
    if (!is_first) out += ',';
    is_first = false;
    out += '[';
    append_string(out, line.substr(0, bar));
    out += ',';
    append_string(out, line.substr(bar + 1));
    out += ']';
  }
  out += ']';
}

}  // namespace

std::string trace_json(const Trace& trace) {
  std::string out = "{";
  const auto text = [&](const char* key, const std::string& value) {
    append_key(out, key);
    append_string(out, value);
  };
  text("format", "hsr-trace/1");
  text("method", trace.method);
  text("title", trace.title);
  text("view", trace.view);
  append_key(out, "scene");
  append_scene(out, trace.scene);
  append_key(out, "pseudocode");
  append_pseudocode(out, trace.pseudocode);
  append_key(out, "runs");
  append_list(out, trace.runs, [&](const TraceRun& run) {
    out += "{";
    append_key(out, "name");
    append_string(out, run.name);
    if (run.scene) {
      append_key(out, "scene");
      append_scene(out, *run.scene);
    }
    append_key(out, "steps");
    append_list(out, run.steps, [&](const TraceStep& step) {
      out += '\n';
      step.append_to(out);
    });
    append_key(out, "result");
    out += run.result + "}";
  });
  return out + "}\n";
}

}  // namespace hsr::internal
