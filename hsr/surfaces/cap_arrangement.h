#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "hsr/scene/section_caps.h"
#include "hsr/surfaces/plane_rings.h"

namespace hsr::internal {

/// A part of a side of caps between two crossings, and the objects inside which it has its left and its right side, left as it runs in
/// the plane's own coordinates.
struct CapPart {
  std::uint32_t side;
  SectionCaps::ExactPlace from, to;
  SectionCaps::Place about_from, about_to;  ///< the same in doubles with a bound
  std::vector<std::uint32_t> left, right;
  std::uint32_t from_number = 0, to_number = 0;  ///< of all places where parts end: equal where these are
};

/// A part from one end to the other.
struct DirectedPart {
  const CapPart* part;
  bool reversed;

  const SectionCaps::ExactPlace& from() const { return reversed ? part->to : part->from; }
  const SectionCaps::ExactPlace& to() const { return reversed ? part->from : part->to; }
  std::uint32_t from_number() const { return reversed ? part->to_number : part->from_number; }
  std::uint32_t to_number() const { return reversed ? part->from_number : part->to_number; }
  const std::vector<std::uint32_t>& left() const { return reversed ? part->right : part->left; }
  const std::vector<std::uint32_t>& right() const { return reversed ? part->left : part->right; }
  SectionCaps::ExactPlace along() const { return {to()[0] - from()[0], to()[1] - from()[1]}; }
  SectionCaps::Place about_along() const {
    const SectionCaps::Place &p = reversed ? part->about_to : part->about_from,
                             &q = reversed ? part->about_from : part->about_to;
    return {q[0] - p[0], q[1] - p[1]};
  }
  /// Whether the other one has the direction of this, or the opposite one.
  bool is_parallel_to(const DirectedPart& other) const;
};

/// Parts that go straight on, from the first to the last, both in the direction of the run.
struct CapRun {
  DirectedPart first, last;
};

/// The sides of the caps cut where others cross or touch them; of sides that coincide, one. What has the same objects on both sides is
/// left out.
/// Exact: yes. Cost: O(m log m), and cross products for each two sides whose boxes touch.
class CapArrangement {
 public:
  explicit CapArrangement(const SectionCaps& caps);

  const std::vector<CapPart>& parts() const { return parts_; }

  /// The parts that are chosen, those joined that go straight on where no other chosen part begins or ends, if they agree.
  std::vector<CapRun> runs(const std::function<bool(const CapPart&)>& is_chosen,
                           const std::function<bool(const DirectedPart&, const DirectedPart&)>& agree) const;
  /// A side that the place is on and that is not parallel to the part; none: there is no such side.
  std::optional<std::uint32_t> side_across(const SectionCaps::ExactPlace& at, const DirectedPart& part) const;
  /// The parts of an open side that no cap covers: shares of the way along it, in pairs.
  std::vector<std::array<Rational, 2>> uncovered(const CapSide& open) const;
  /// The point in space of a place on a side.
  RationalVector point(std::uint32_t side, const SectionCaps::ExactPlace& at) const;

 private:
  void add_cuts(const CapSide& own, std::uint32_t other, std::vector<Rational>& cuts) const;
  bool certainly_apart(std::uint32_t k, std::uint32_t other) const;
  std::vector<CapPart> parts_of(std::uint32_t k) const;
  void number_ends();

  const SectionCaps& caps_;
  std::vector<CapPart> parts_;
};

}  // namespace hsr::internal
