#include "tests/section/kept_boxes_oracle.h"

#include <algorithm>
#include <optional>

namespace hsr {

using namespace internal;

namespace {

const Rational zero = 0.0, one = 1.0;

RationalVector sum(const RationalVector& p, const Rational& s, const RationalVector& d) {
  return {p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]};
}

}  // namespace

KeptBoxesOracle::KeptBoxesOracle(const CutBoxes& boxes, const View& view) : view_(view) {
  for (std::size_t first = 0; first < boxes.points.size(); first += 24) {
    Box box{rational(boxes.points[first]), rational(boxes.points[first])};
    for (std::size_t k = first; k < first + 24; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Rational x = boxes.points[k][static_cast<int>(axis)];
        box.low[axis] = std::min(box.low[axis], x);
        box.high[axis] = std::max(box.high[axis], x);
      }
    boxes_.push_back(box);
  }
  const auto value = [](const SectionPlane& plane) {
    return Value{rational(plane.normal), -dot(rational(plane.normal), rational(plane.point))};
  };
  std::vector<SectionPlane> planes = view.planes;
  if (view.section) planes.push_back(*view.section);
  for (const SectionPlane& plane : planes) {
    const Value v = value(plane);
    (at_eye(v) == zero ? edge_on_ : facing_).push_back(v);
  }
  if (view.far) far_.push_back(value(*view.far));
}

Rational KeptBoxesOracle::at_eye(const Value& v) const {
  const RationalVector e = rational(view_.viewpoint.at);
  return view_.is_perspective() ? v.at(e) : dot(v.gradient, e);
}

RationalVector KeptBoxesOracle::toward(const RationalVector& p) const {
  const RationalVector e = rational(view_.viewpoint.at);
  return view_.is_perspective() ? minus(e, p) : e;
}

RationalVector KeptBoxesOracle::on_sight(const RationalVector& p, const Rational& s) const { return sum(p, s, toward(p)); }

KeptBoxesOracle::Value KeptBoxesOracle::through_eye(const Value& a, const Value& b) const {
  const Rational x = at_eye(b), y = at_eye(a);
  Value v;
  for (std::size_t k = 0; k < 3; ++k) v.gradient[k] = x * a.gradient[k] - y * b.gradient[k];
  v.offset = x * a.offset - y * b.offset;
  return v;
}

bool KeptBoxesOracle::is_kept(const RationalVector& p) const {
  for (const Value& far : far_)
    if (far.at(p) > zero) return false;
  const auto is_behind = [&](const Value& v) { return !(v.at(p) < zero); };
  if (facing_.empty() && edge_on_.empty()) return true;
  return std::any_of(facing_.begin(), facing_.end(), is_behind) || std::any_of(edge_on_.begin(), edge_on_.end(), is_behind);
}

/// What of the way from p toward the viewer is left: all of it beside a plane that is seen edge-on, or as far as the first of the others. On
/// the border between the two, both.
std::vector<KeptBoxesOracle::Part> KeptBoxesOracle::kept_parts(const RationalVector& p) const {
  std::vector<Part> parts;
  const bool is_beside = std::any_of(edge_on_.begin(), edge_on_.end(), [&](const Value& v) { return !(v.at(p) < zero); });
  if (is_beside || (facing_.empty() && edge_on_.empty())) parts.push_back({zero, zero, true, false});
  const bool is_within = std::all_of(edge_on_.begin(), edge_on_.end(), [&](const Value& v) { return !(v.at(p) > zero); });
  if (!is_within || facing_.empty()) return parts;
  Part part{zero, zero, false, true};
  for (const Value& v : facing_) {
    const Rational at_p = v.at(p), eye = at_eye(v), change = view_.is_perspective() ? eye - at_p : eye;
    if (at_p < zero) continue;
    const Rational s = -at_p / change;
    part.to = part.is_empty ? s : std::max(part.to, s);
    part.is_empty = false;
  }
  parts.push_back(part);
  return parts;
}

/// A box that touches the plane from the viewer's side has one only where a face of it is in the plane.
bool KeptBoxesOracle::has_cap(const Box& box, const Value& plane) const {
  bool is_in_front = false, is_behind = false;
  int on = 0;
  for (unsigned k = 0; k < 8; ++k) {
    const RationalVector corner = {((k & 1U) != 0 ? box.high : box.low)[0], ((k & 2U) != 0 ? box.high : box.low)[1],
                                   ((k & 4U) != 0 ? box.high : box.low)[2]};
    const Rational at = plane.at(corner);
    is_in_front = is_in_front || at < zero;
    is_behind = is_behind || at > zero;
    if (at == zero) ++on;
  }
  return is_in_front && (is_behind || on >= 4);
}

/// Whether the line of sight goes through a cap in front of p, or at it.
bool KeptBoxesOracle::is_capped(const RationalVector& p) const {
  for (const Part& part : kept_parts(p)) {
    if (part.is_endless || part.is_empty) continue;
    const RationalVector x = on_sight(p, part.to);
    for (const Value& plane : facing_) {
      if (plane.at(x) != zero) continue;
      for (const Box& box : boxes_) {
        bool is_in = true;
        for (std::size_t k = 0; k < 3; ++k) is_in = is_in && !(x[k] < box.low[k]) && !(box.high[k] < x[k]);
        if (is_in && has_cap(box, plane)) return true;
      }
    }
  }
  return false;
}

bool KeptBoxesOracle::is_hidden(const RationalVector& p) const {
  if (is_capped(p)) return true;
  const RationalVector d = toward(p);
  for (const Part& part : kept_parts(p)) {
    if (part.is_empty) continue;
    for (const Box& box : boxes_)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const RationalVector* const bound : {&box.low, &box.high}) {
          // The shares of the way at which it is in the face.
          std::optional<Rational> low = zero, high;
          if (!part.is_endless) high = part.to;
          if (view_.is_perspective()) high = high ? std::min(*high, one) : one;
          bool is_missed = false;
          const auto clip = [&](const Rational& from, const Rational& slope) {  // from + s slope >= 0
            if (slope == zero) {
              is_missed = is_missed || from < zero;
            } else if (slope > zero) {
              low = std::max(*low, -from / slope);
            } else {
              const Rational s = -from / slope;
              high = high ? std::min(*high, s) : s;
            }
          };
          for (std::size_t k = 0; k < 3; ++k) {
            const Rational lowest = k == axis ? (*bound)[k] : box.low[k], highest = k == axis ? (*bound)[k] : box.high[k];
            clip(p[k] - lowest, d[k]);
            clip(highest - p[k], -d[k]);
          }
          if (is_missed || (high && *high < *low)) continue;
          // Something of it in front of p.
          if (!high || *high > zero) return true;
        }
  }
  return false;
}

/// Whether a face has a point of the way toward the viewer, from one share, which counts, to another, which does not.
bool KeptBoxesOracle::is_in_face(const RationalVector& p, const Rational& from, const Rational& to) const {
  const RationalVector d = toward(p);
  for (const Box& box : boxes_)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const RationalVector* const bound : {&box.low, &box.high}) {
        Rational low = from, high = to;
        bool is_missed = false;
        const auto clip = [&](const Rational& at, const Rational& slope) {  // at + s slope >= 0
          if (slope == zero)
            is_missed = is_missed || at < zero;
          else if (slope > zero)
            low = std::max(low, -at / slope);
          else
            high = std::min(high, -at / slope);
        };
        for (std::size_t k = 0; k < 3; ++k) {
          clip(p[k] - (k == axis ? (*bound)[k] : box.low[k]), d[k]);
          clip((k == axis ? (*bound)[k] : box.high[k]) - p[k], -d[k]);
        }
        if (!is_missed && !(high < low) && low < to) return true;
      }
  return false;
}

/// The plane is moved to what is left by less than anything: a box that reaches into that has a cap there, from this side.
bool KeptBoxesOracle::is_seen_from_cut(const RationalVector& p) const {
  for (const Value& v : edge_on_)
    if (!(v.at(p) < zero)) return false;
  std::optional<Rational> exit;
  for (const Value& v : facing_) {
    const Rational s = -v.at(p) / at_eye(v);
    exit = exit ? std::max(*exit, s) : s;
  }
  if (!exit || !(*exit < zero)) return false;
  const RationalVector x = on_sight(p, *exit);
  for (const Value& plane : facing_) {
    if (plane.at(x) != zero) continue;
    Value other = plane;
    other.offset = -other.offset;
    for (Rational& g : other.gradient) g = -g;
    for (const Box& box : boxes_) {
      bool is_in = true;
      for (std::size_t k = 0; k < 3; ++k) is_in = is_in && !(x[k] < box.low[k]) && !(box.high[k] < x[k]);
      if (is_in && has_cap(box, other)) return false;
    }
  }
  return !is_in_face(p, *exit, zero);
}

std::vector<Rational> KeptBoxesOracle::changes(const RationalVector& a, const RationalVector& b) const {
  std::vector<Value> values = facing_;
  values.insert(values.end(), edge_on_.begin(), edge_on_.end());
  values.insert(values.end(), far_.begin(), far_.end());
  for (std::size_t i = 0; i < facing_.size(); ++i)
    for (std::size_t j = i + 1; j < facing_.size(); ++j) values.push_back(through_eye(facing_[i], facing_[j]));
  for (const Box& box : boxes_)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const RationalVector* const bound : {&box.low, &box.high}) {
        Value face{{zero, zero, zero}, -(*bound)[axis]};
        face.gradient[axis] = one;
        values.push_back(face);
        for (const Value& plane : facing_) values.push_back(through_eye(face, plane));
        for (std::size_t other = axis + 1; other < 3; ++other)
          for (const RationalVector* const second : {&box.low, &box.high}) {
            Value beside{{zero, zero, zero}, -(*second)[other]};
            beside.gradient[other] = one;
            values.push_back(through_eye(face, beside));
          }
      }
  std::vector<Rational> changes = {zero, one};
  for (const Value& v : values) {
    const Rational at_a = v.at(a), at_b = v.at(b);
    if (at_a == at_b) continue;
    const Rational t = at_a / (at_a - at_b);
    if (t > zero && t < one) changes.push_back(t);
  }
  std::sort(changes.begin(), changes.end());
  changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
  return changes;
}

KeptBoxesOracle::Seen KeptBoxesOracle::seen(const RationalVector& p) const {
  const RationalVector d = toward(p);
  // Shares of the way at which what is left begins; the eye is at 1.
  std::optional<Rational> limit;
  const bool is_beside = std::any_of(edge_on_.begin(), edge_on_.end(), [&](const Value& v) { return v.at(p) > zero; });
  bool is_all_gone = !is_beside && facing_.empty() && !edge_on_.empty();
  if (is_all_gone) return {};
  if (!is_beside)
    for (const Value& v : facing_) {
      const Rational change = view_.is_perspective() ? at_eye(v) - v.at(p) : at_eye(v);
      if (!(change < zero)) continue;  // met behind the eye
      const Rational s = -v.at(p) / change;
      limit = limit ? std::max(*limit, s) : s;
    }
  if (!is_beside && !facing_.empty() && !limit) return {};
  if (limit)
    for (const Value& plane : facing_) {
      const RationalVector x = sum(p, *limit, d);
      if (plane.at(x) != zero) continue;
      for (const Box& box : boxes_) {
        bool is_in = true;
        for (std::size_t k = 0; k < 3; ++k) is_in = is_in && box.low[k] < x[k] && x[k] < box.high[k];
        bool is_before_far = true;
        for (const Value& far : far_) is_before_far = is_before_far && !(far.at(x) > zero);
        if (is_in && has_cap(box, plane)) return {is_before_far ? Seen::Kind::cap : Seen::Kind::nothing, 0};
        // A box whose face is in the plane, from the front.
        bool is_on = true;
        for (std::size_t k = 0; k < 3; ++k) is_on = is_on && !(x[k] < box.low[k]) && !(box.high[k] < x[k]);
        if (is_on && has_cap(box, plane)) return {is_before_far ? Seen::Kind::cap : Seen::Kind::nothing, 0};
      }
    }
  Seen best;
  Rational nearest;
  for (std::uint32_t b = 0; b < boxes_.size(); ++b)
    // In the order in which cut_boxes() lists them.
    for (std::uint32_t f = 0; f < 6; ++f) {
      const std::size_t axis = f < 2 ? 2 : f == 2 || f == 4 ? 1 : 0;
      const bool is_high = f == 1 || f == 3 || f == 4;
      const Rational at = (is_high ? boxes_[b].high : boxes_[b].low)[axis];
      if (d[axis] == zero) continue;
      const Rational s = (at - p[axis]) / d[axis];
      if (limit && s > *limit) continue;
      if (view_.is_perspective() && !(s < one)) continue;
      const RationalVector x = sum(p, s, d);
      bool is_in = true;
      for (std::size_t k = 0; k < 3; ++k) is_in = is_in && (k == axis || (boxes_[b].low[k] < x[k] && x[k] < boxes_[b].high[k]));
      for (const Value& far : far_) is_in = is_in && !(far.at(x) > zero);
      if (!is_in || (best.kind == Seen::Kind::face && !(s > nearest))) continue;
      best = {Seen::Kind::face, 6 * b + f};
      nearest = s;
    }
  return best;
}

}  // namespace hsr
