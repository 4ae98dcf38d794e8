#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hsr/io/read/decimal.h"
#include "hsr/io/read/source.h"

namespace hsr::internal::read {

/// Goes once through a text, word by word and line by line; what does not fit is refused with its line.
///
/// Lines end with LF, CR LF or CR. Words are separated by blanks. With Syntax::comment set, that character at the begin of a
/// word makes the rest of the line a comment; with Syntax::continuation, a backslash joins two lines if
/// only blanks follow it on its own. Lines are not counted on the way: an error counts them then.
class TextScanner {
 public:
  struct Syntax {
    char comment = '\0';
    bool continuation = false;
  };

  TextScanner(const Source& source, Syntax syntax, std::size_t first_byte = 0)
      : source_(source),
        begin_(source.bytes.data()),
        end_(begin_ + source.bytes.size()),
        p_(begin_ + first_byte),
        syntax_(syntax) {}

  /// Nothing is left, not even on this line. Call after skip_lines or next_line.
  bool at_end() const { return p_ == end_; }
  const char* position() const { return p_; }
  std::size_t offset() const { return static_cast<std::size_t>(p_ - begin_); }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - p_); }
  void move_to(const char* p) { p_ = p; }

  void skip_blanks() {
    for (;;) {
      while (is_blank(*p_)) ++p_;
      const char* const next = continued(p_);
      if (next == nullptr) return;
      p_ = next;
    }
  }
  /// Skips blanks. @returns true if nothing more is on this line
  bool at_line_end() {
    skip_blanks();
    return is_line_end(p_) || (syntax_.comment != '\0' && *p_ == syntax_.comment);
  }
  /// To the begin of the next line, whatever this one still holds; a comment is never continued.
  void next_line();
  /// To the next word, on this line or a later one. @returns false at the end of the text
  bool skip_lines() {
    while (at_line_end()) {
      if (p_ == end_) return false;
      if (is_line_end(p_))
        ++p_;
      else
        skip_comment();
    }
    return true;
  }

  /// The next word of this line, empty at its end. Goes behind it.
  std::string_view word() {
    if (at_line_end()) return {};
    const char* const start = p_;
    while (!is_delimiter(p_)) ++p_;
    return {start, static_cast<std::size_t>(p_ - start)};
  }
  /// What is left of this line, without the blanks around it; comments and continuations are not looked for.
  std::string_view rest_of_line();
  /// The same, where a backslash that stands alone at the end of the line joins the next one to it. One behind a word belongs to
  /// the word: names of materials are paths at times.
  std::string rest_of_joined_lines();

  /// The finite number that is the next word of this line. @param expected for the message
  double number(const char* expected) {
    if (at_line_end()) refuse(p_, expected);
    const ScannedDecimal scanned = scan_decimal(p_, end_);
    if (scanned.status != Decimal::number || !is_delimiter(scanned.end)) refuse_number(scanned.status, expected);
    p_ = scanned.end;
    return scanned.value;
  }
  /// The same, if the next word of this line is one; does not move otherwise, but for blanks.
  std::optional<double> number_if_any() {
    if (at_line_end()) return {};
    const ScannedDecimal scanned = scan_decimal(p_, end_);
    if (scanned.status != Decimal::number || !is_delimiter(scanned.end)) return {};
    p_ = scanned.end;
    return scanned.value;
  }
  /// The whole number that is the next word of this line; beyond the range of the type, its end.
  std::int64_t integer(const char* expected) {
    if (at_line_end()) refuse(p_, expected);
    const char* const start = p_;
    const std::int64_t value = integer_prefix();
    if (p_ == start || !is_delimiter(p_)) refuse(start, expected);
    return value;
  }
  /// As `integer`, but something may follow without a blank. Does not move if no whole number is here.
  std::int64_t integer_prefix() {
    const char* const start = p_;
    const bool negative = *p_ == '-';
    if (*p_ == '-' || *p_ == '+') ++p_;
    const char* const digits = p_;
    std::int64_t value = 0;
    while (*p_ >= '0' && *p_ <= '9') {
      if (value < most_integer) value = 10 * value + (*p_ - '0');
      ++p_;
    }
    if (p_ == digits) p_ = start;
    return negative ? -value : value;
  }

  /// Does a word end before `p`?
  bool is_delimiter(const char* p) const { return is_blank(*p) || is_line_end(p) || continued(p) != nullptr; }

  std::size_t line() const { return line_of(p_); }
  std::size_t line_of(const char* p) const;
  /// @throws InputError: line, the word at `p`, what was expected
  [[noreturn]] void refuse(const char* p, const std::string& expected) const;
  [[noreturn]] void refuse_here(const std::string& expected) {
    skip_blanks();
    refuse(p_, expected);
  }
  /// @throws InputError: line of `p`, what was found, what was expected
  [[noreturn]] void refuse(const char* p, const std::string& found, const std::string& expected) const {
    source_.refuse("line " + std::to_string(line_of(p)), "found " + found + ", expected " + expected);
  }

 private:
  static constexpr std::int64_t most_integer = std::int64_t{1} << 58;

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  // A NUL in the text is an ordinary character, the one behind the text is not.
  bool is_line_end(const char* p) const { return *p == '\n' || *p == '\r' || (*p == '\0' && p == end_); }
  /// Where the line goes on that is continued at `p`; nullptr if none is.
  const char* continued(const char* p) const { return *p == '\\' && syntax_.continuation ? behind_backslash(p) : nullptr; }
  const char* behind_backslash(const char* p) const;
  void skip_comment();
  [[noreturn]] void refuse_number(Decimal status, const char* expected) const;

  const Source& source_;
  const char* begin_;
  const char* end_;
  const char* p_;
  Syntax syntax_;
};

}  // namespace hsr::internal::read
