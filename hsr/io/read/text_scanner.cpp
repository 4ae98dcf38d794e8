#include "hsr/io/read/text_scanner.h"

#include <algorithm>

namespace hsr::internal::read {

void TextScanner::skip_comment() {
  while (!is_line_end(p_)) ++p_;
}

void TextScanner::next_line() {
  while (!is_line_end(p_)) {
    if (const char* const next = continued(p_)) {
      p_ = next;
    } else if (syntax_.comment != '\0' && *p_ == syntax_.comment && p_ != begin_ && is_blank(p_[-1])) {
      skip_comment();
    } else {
      ++p_;
    }
  }
  if (p_ != end_) p_ += *p_ == '\r' && p_[1] == '\n' ? 2 : 1;
}

std::string_view TextScanner::rest_of_line() {
  while (is_blank(*p_)) ++p_;
  const char* const start = p_;
  skip_comment();
  const char* stop = p_;
  while (stop != start && is_blank(stop[-1])) --stop;
  return {start, static_cast<std::size_t>(stop - start)};
}

std::string TextScanner::rest_of_joined_lines() {
  std::string text;
  for (;;) {
    std::string_view part = rest_of_line();
    const bool goes_on =
        syntax_.continuation && !part.empty() && part.back() == '\\' && (part.size() == 1 || is_blank(part[part.size() - 2]));
    if (goes_on) part.remove_suffix(1);
    while (!part.empty() && is_blank(part.back())) part.remove_suffix(1);
    if (!text.empty() && !part.empty()) text += ' ';
    text += part;
    if (!goes_on || p_ == end_) return text;
    p_ += *p_ == '\r' && p_[1] == '\n' ? 2 : 1;
  }
}

const char* TextScanner::behind_backslash(const char* p) const {
  do ++p;
  while (is_blank(*p));
  if (!is_line_end(p)) return nullptr;
  if (p == end_) return p;
  return p + (*p == '\r' && p[1] == '\n' ? 2 : 1);
}

std::size_t TextScanner::line_of(const char* p) const {
  std::size_t line = 1;
  for (const char* q = begin_; q != p; ++q)
    if (*q == '\n' || (*q == '\r' && q[1] != '\n')) ++line;
  return line;
}

void TextScanner::refuse(const char* p, const std::string& expected) const {
  const char* stop = p;
  while (!is_delimiter(stop)) ++stop;
  if (stop == p) refuse(p, p == end_ ? "the end of the file" : "the end of the line", expected);
  if (syntax_.comment != '\0' && *p == syntax_.comment) refuse(p, "the end of the line", expected);
  refuse(p, in_quotes({p, static_cast<std::size_t>(stop - p)}), expected);
}

void TextScanner::refuse_number(Decimal status, const char* expected) const {
  refuse(p_, status == Decimal::too_large ? std::string(expected) + " that a double can hold" : std::string(expected));
}

}  // namespace hsr::internal::read
