#include "study/explain/nearness_spans.h"

#include "study/html_page.h"

namespace hsr::internal {

void NearnessSpans::begin(TriangleId t, int row, int begin, int end) {
  finish();
  if (begin >= end) return;
  is_open_ = true;
  face_ = picture_.scene().mesh.face_of[t].value;
  row_ = row;
  begin_ = begin;
  end_ = end;
  passed_ = 0;
  cells_.clear();
  found_text_.clear();
  held_text_.clear();
  has_question_ = false;
}

void NearnessSpans::add(const NearnessSample& s) {
  const std::string now = trace_text(s.nearness);
  found_text_ += (found_text_.empty() ? "" : " ") + now;
  held_text_ += (held_text_.empty() ? "" : " ") + trace_text(s.held);
  int& holder = holders_.at(s.column, s.row);
  if (!has_question_ && holder >= 0 && holder != static_cast<int>(face_)) {
    has_question_ = true;
    asked_sample_ = s;
    asked_holder_ = holder;
  }
  if (!s.is_shown) return;
  ++passed_;
  holder = static_cast<int>(face_);
  cells_.push_back({s.column, s.row, rounded_text(s.nearness, 3), holder});
}

void NearnessSpans::finish() {
  if (!is_open_) return;
  is_open_ = false;
  const std::string name = picture_.name(face_);
  std::string says = "Face " + name + ", row " + std::to_string(row_) + ", " + columns_text(begin_, end_) + ": ";
  if (passed_ == end_ - begin_)
    says += "it is nearer than what is held at all of them, and is stored.";
  else if (passed_ == 0)
    says += "it is nowhere nearer: what is held stays.";
  else
    says += "it is nearer at " + std::to_string(passed_) + " of " + std::to_string(end_ - begin_) + " samples.";
  TraceStep& step = run_.step("span", passed_ > 0 ? "store" : "test", says);
  step.face(face_).row(row_).number("nearness of " + name, found_text_).number("held before", held_text_);
  if (!cells_.empty()) step.cells(cells_);
  // Not twice of the same two faces, unless the answer differs.
  if (!has_question_ || asked_.size() >= 6 || !asked_.insert({asked_holder_, face_, asked_sample_.is_shown}).second) return;
  const std::string before = picture_.name(static_cast<std::uint32_t>(asked_holder_));
  step.ask({"Row " + std::to_string(row_) + ", column " + std::to_string(asked_sample_.column) + ": the nearness " +
                trace_text(asked_sample_.held) + " of " + before + " is held, and " + name + " has " +
                trace_text(asked_sample_.nearness) + " there. Larger is nearer. Which face has the sample then?",
            {before, name},
            asked_sample_.is_shown ? 1U : 0U});
}

}  // namespace hsr::internal
