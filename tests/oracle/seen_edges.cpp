#include "tests/oracle/seen_edges.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "tests/oracle/edge_class_oracle.h"
#include "tests/oracle/intersections_oracle.h"
#include "tests/oracle/visible_lines_oracle.h"

namespace hsr::oracle {

namespace {

std::string name(VertexId a, VertexId b) { return std::to_string(a.value) + "-" + std::to_string(b.value); }

bool asked_for(const LineOptions& options, EdgeClass c) { return options.classes[static_cast<std::size_t>(c)]; }

bool same_class(const SeenEdge& expected, const SeenEdge& found) {
  return found.edge_class == expected.edge_class || (expected.class_is_uncertain && found.edge_class == expected.other_class);
}

std::vector<Interval> clipped(const std::vector<Interval>& intervals, const Interval& part) {
  std::vector<Interval> out;
  for (const Interval& i : intervals) {
    Interval x{std::max(i.from, part.from), std::min(i.to, part.to)};
    if (x.from < x.to) out.push_back(std::move(x));
  }
  return out;
}

// What is seen of a part of a line.
EdgeVisibility within(const EdgeVisibility& whole, const Interval& part) {
  EdgeVisibility v = whole;
  v.beyond = part;
  v.hidden = clipped(whole.hidden, part);
  v.visible = clipped(whole.visible, part);
  v.shadows.clear();
  for (const Shadow& s : whole.shadows)
    for (Interval& i : clipped({s.interval}, part)) v.shadows.push_back({s.triangle, std::move(i)});
  return v;
}

void fill_cuts(SeenEdge& e, const EdgeVisibility& v) {
  e.cuts.push_back(v.beyond.from);
  e.starts_hidden = !v.hidden.empty() && v.hidden.front().from == v.beyond.from;
  std::vector<Interval> all = v.hidden;
  all.insert(all.end(), v.visible.begin(), v.visible.end());
  std::sort(all.begin(), all.end(), [](const Interval& p, const Interval& q) { return p.from < q.from; });
  for (const Interval& part : all) e.cuts.push_back(part.to);
}

// What is behind each part, apart where it is visible and where it is hidden.
std::vector<ClassPart> by_visibility(const std::vector<ClassPart>& parts, const EdgeVisibility& v) {
  std::vector<ClassPart> all;
  for (const ClassPart& part : parts) {
    if (part.behind == part.behind_seen || !v.is_seen) {
      all.push_back(part);
      continue;
    }
    const EdgeVisibility of_part = within(v, part.part);
    const std::size_t first = all.size();
    for (const Interval& seen : of_part.visible) all.push_back({seen, part.verdict, part.behind_seen});
    for (const Interval& hidden : of_part.hidden) all.push_back({hidden, part.verdict, part.behind});
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
              [](const ClassPart& x, const ClassPart& y) { return x.part.from < y.part.from; });
  }
  return all;
}

// What --why has to name: of the faces whose shadow covers the start, the one that reaches furthest, the lowest index first.
std::string occluders_by_oracle(const Mesh& mesh, const EdgeVisibility& whole, const Interval& part) {
  const EdgeVisibility truth = within(whole, part);
  std::map<FaceId, std::vector<Interval>> of_face;
  for (const Shadow& s : truth.shadows) of_face[mesh.face_of[s.triangle]].push_back(s.interval);
  for (auto& [face, intervals] : of_face) intervals = united(intervals);
  std::string text;
  for (const Interval& hidden : truth.hidden) {
    Q reached = hidden.from;
    while (reached < hidden.to) {
      const Interval* best = nullptr;
      FaceId best_face;
      for (const auto& [face, intervals] : of_face) {
        for (const Interval& i : intervals) {
          if (i.from > reached || i.to <= (best == nullptr ? reached : best->to)) continue;
          best = &i;
          best_face = face;
        }
      }
      text += " face " + std::to_string(best_face.value) + " " + best->from.get_str() + " " + best->to.get_str();
      reached = best->to;
    }
  }
  return text;
}

std::string occluders_text(const Mesh& mesh, const View& view, const VisibleLines& lines, const Line& line) {
  std::string text;
  for (const Occluder& o : lines.occluders_of(line)) {
    const SupportingLine support = supporting_line_of(mesh, lines, line);
    const Q from = exact(exact_parameter(mesh, view, support, o.from)), to = exact(exact_parameter(mesh, view, support, o.to));
    text += " face " + std::to_string(o.face.value) + " " + from.get_str() + " " + to.get_str();
  }
  return text;
}

}  // namespace

const char* to_text(EdgeClass edge_class) {
  switch (edge_class) {
    case EdgeClass::outline:
      return "outline";
    case EdgeClass::sharp:
      return "sharp";
    case EdgeClass::boundary:
      return "boundary";
    case EdgeClass::intersection:
      return "intersection";
    case EdgeClass::wire:
      return "wire";
    case EdgeClass::smooth:
      return "smooth";
    case EdgeClass::material:
      return "material";
    case EdgeClass::joint:
      return "joint";
    case EdgeClass::section:
    case EdgeClass::hatching:
    case EdgeClass::overhead:
      break;  // of drawings
  }
  return "no class";
}

std::string intervals_text(const SeenEdge& edge) {
  if (edge.cuts.empty()) return "nothing";
  std::string text = edge.cuts.front().get_str();
  bool hidden = edge.starts_hidden;
  for (std::size_t k = 1; k < edge.cuts.size(); ++k, hidden = !hidden)
    text += (hidden ? " hidden " : " visible ") + edge.cuts[k].get_str();
  return text;
}

std::string to_text(const SeenEdge& edge) {
  if (edge.a.is_valid())
    return name(edge.a, edge.b) + (edge.is_behind ? " behind " : " ") + to_text(edge.edge_class) + ": " + intervals_text(edge);
  const auto point = [](const Vec& p) { return p.x.get_str() + "," + p.y.get_str() + "," + p.z.get_str(); };
  return "triangles " + std::to_string(edge.s.value) + " x " + std::to_string(edge.t.value) + " " + point(edge.from) + " to " +
         point(edge.to) + " " + to_text(edge.edge_class) + ": " + intervals_text(edge);
}

std::string to_text(const std::vector<SeenEdge>& edges) {
  std::string text;
  for (const SeenEdge& e : edges) text += to_text(e) + "\n";
  return text;
}

std::vector<SeenEdge> seen_by_oracle(const SceneView& scene, const LineOptions& options) {
  const Mesh& mesh = scene.mesh();
  const View& view = scene.view();
  const VisibleLinesOracle oracle(mesh, view);
  std::vector<SeenEdge> out;
  const auto add = [&](EdgeId id, const EdgeVisibility& v, const Interval& part, const ClassVerdict& verdict, bool is_behind) {
    SeenEdge e{mesh.edges[id].a, mesh.edges[id].b, verdict.edge_class, false, {}, verdict.is_near_crease};
    e.is_behind = is_behind;
    if (e.class_is_uncertain) e.other_class = e.edge_class == EdgeClass::sharp ? verdict.flat : EdgeClass::sharp;
    const bool is_asked = asked_for(options, e.edge_class);
    const bool other_is_asked = e.class_is_uncertain && asked_for(options, e.other_class);
    if (!is_asked && !other_is_asked) return;
    e.may_be_absent = e.class_is_uncertain && (is_behind || is_asked != other_is_asked);
    if (is_behind) {
      e.cuts = {part.from, part.to};
      e.starts_hidden = true;
    } else if (v.is_seen) {
      fill_cuts(e, within(v, part));
    }
    out.push_back(std::move(e));
  };
  std::vector<EdgeVisibility> of_edge;
  std::vector<std::optional<Interval>> beyond;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    of_edge.push_back(oracle.visibility(EdgeId(i)));
    beyond.push_back(of_edge.back().is_seen ? std::optional(of_edge.back().beyond) : std::nullopt);
  }
  const auto of_edges = class_parts(mesh, view, scene.labels(), scene.options().coplanar, options.crease, beyond);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const EdgeId id(i);
    const EdgeVisibility& v = of_edge[i];
    const std::vector<ClassPart>& parts = of_edges[i];
    // Of each of the two, neighbours that do not differ are one.
    for (const bool is_behind : {false, true}) {
      std::optional<ClassPart> open;
      const auto end = [&] {
        if (open && open->hidden && !is_behind) {
          // Each interval has the class of what is seen, or of what is hidden.
          const EdgeVisibility of_part = within(v, open->part);
          for (const Interval& seen : of_part.visible) add(id, v, seen, *open->verdict, false);
          const bool is_diagonal = mesh.edges[id].diagonal && !mesh.edges[id].of_face;
          for (const Interval& hidden : of_part.hidden)
            if (!is_diagonal || open->hidden->edge_class != EdgeClass::smooth) add(id, v, hidden, *open->hidden, false);
        } else if (open) {
          add(id, v, open->part, *open->verdict, is_behind);
        }
        open.reset();
      };
      for (const ClassPart& part : is_behind ? by_visibility(parts, v) : parts) {
        const auto& verdict = is_behind ? part.behind : part.verdict;
        // Parts that differ in either are parts of what is seen; what is behind goes on across what is seen.
        if (is_behind && open && verdict && *open->verdict == *verdict && open->part.to == part.part.from) {
          open->part.to = part.part.to;
          continue;
        }
        end();
        if (verdict) open = ClassPart{part.part, verdict, {}, part.hidden};
      }
      end();
    }
  }
  if (!asked_for(options, EdgeClass::intersection)) return out;
  const std::vector<std::uint32_t>& shape = scene.labels().shape;
  for (const Piercing& p : piercings(mesh, view)) {
    const auto shape_of = [&](FacetId facet) {
      return shape.empty() ? FaceLabels::none : shape[mesh.face_of[first_triangle(facet)].value];
    };
    if (shape_of(p.s) != FaceLabels::none && shape_of(p.s) == shape_of(p.t)) continue;
    SeenEdge e{{}, {}, EdgeClass::intersection, false, {}};
    e.s = p.s;
    e.t = p.t;
    e.from = p.from;
    e.to = p.to;
    const EdgeVisibility v = oracle.visibility(p.from, p.to);
    if (v.is_seen) fill_cuts(e, v);
    out.push_back(std::move(e));
  }
  return out;
}

std::vector<SeenEdge> seen_edges(const Mesh& mesh, const View& view, const VisibleLines& lines) {
  std::vector<SeenEdge> out;
  for (const Line& line : lines.lines) {
    const SupportingLine support = supporting_line_of(mesh, lines, line);
    SeenEdge e{support.a, support.b, line.edge_class, line.starts_hidden, {}};
    e.is_behind = line.is_behind;
    if (line.is_intersection()) {
      const auto point = [&](const Cut& cut) {
        const auto p = exact_point(mesh, view, support, cut);
        return Vec(exact(p[0]), exact(p[1]), exact(p[2]));
      };
      e.s = support.meet.s;
      e.t = support.meet.t;
      e.from = point(support.meet.from);
      e.to = point(support.meet.to);
    }
    for (const Cut& cut : lines.cuts_of(line)) e.cuts.push_back(exact(exact_parameter(mesh, view, support, cut)));
    out.push_back(std::move(e));
  }
  return out;
}

std::vector<std::string> differences(const std::vector<SeenEdge>& expected, const std::vector<SeenEdge>& found) {
  std::vector<std::string> out;
  // Edges by their vertices and along them, then intersections by their triangles and along them.
  const auto key = [](const SeenEdge& e) {
    const Q start = e.cuts.empty() ? Q(0) : e.cuts.front();
    return std::tuple(e.a, e.b, e.s, e.t, e.is_behind, e.from.x, e.from.y, e.from.z, e.to.x, e.to.y, e.to.z, start);
  };
  std::map<decltype(key(SeenEdge())), const SeenEdge*> left;
  for (const SeenEdge& e : expected) left[key(e)] = &e;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SeenEdge& f = found[i];
    if (i > 0 && key(found[i - 1]) >= key(f)) out.push_back("not ascending: " + to_text(f));
    const auto it = left.find(key(f));
    if (it == left.end()) {
      out.push_back("not expected, or twice: " + to_text(f));
      continue;
    }
    const SeenEdge& e = *it->second;
    const bool same_intervals = f.cuts == e.cuts && (f.cuts.empty() || f.starts_hidden == e.starts_hidden);
    if (!same_intervals || !same_class(e, f)) out.push_back("found " + to_text(f) + "; expected " + to_text(e));
    left.erase(it);
  }
  for (const auto& [k, e] : left)
    if (!e->may_be_absent) out.push_back("missing: " + to_text(*e));
  return out;
}

std::vector<std::string> compare_with_oracle(const SceneView& scene, const VisibleLines& lines, const LineOptions& options) {
  const Mesh& mesh = scene.mesh();
  const View& view = scene.view();
  std::vector<std::string> out = differences(seen_by_oracle(scene, options), seen_edges(mesh, view, lines));
  if (options.why) {
    const VisibleLinesOracle oracle(mesh, view);
    for (const Line& line : lines.lines) {
      if (line.is_behind) continue;  // what hides it is what it touches
      const SupportingLine support = supporting_line_of(mesh, lines, line);
      const auto end = [&](const Cut& cut) {
        const auto p = exact_point(mesh, view, support, cut);
        return Vec(exact(p[0]), exact(p[1]), exact(p[2]));
      };
      const EdgeVisibility whole = line.is_intersection() ? oracle.visibility(end(support.meet.from), end(support.meet.to))
                                                          : oracle.visibility(line.edge);
      Interval part;
      if (line.intervals() > 0) {
        part.from = exact(exact_parameter(mesh, view, support, lines.cuts_of(line).front()));
        part.to = exact(exact_parameter(mesh, view, support, lines.cuts_of(line).back()));
      }
      const std::string found = occluders_text(mesh, view, lines, line);
      const std::string expected = occluders_by_oracle(mesh, whole, part);
      if (found != expected) out.push_back("occluders: found" + found + "; expected" + expected);
    }
  } else if (!lines.occluders.empty()) {
    out.push_back("occluders that were not asked for");
  }
  return out;
}

}  // namespace hsr::oracle
