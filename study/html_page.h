#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hsr::internal {

/// With so many digits, in the shortest form: "0.25", "1e-07"
std::string rounded_text(double x, int digits);
/// The shortest text of the same number, or if that is long a power of two, "2^-24", or three digits.
std::string short_text(double x);
std::string html_escaped(const std::string& text);
/// "data:image/png;base64,..."
std::string png_url(std::string_view png);

/// A cell shows a text; a column is sorted by `value` where that is a number, else by the text.
struct HtmlCell {
  std::string text;
  double value = 0;
  bool is_number = false;
  std::string link = {};  ///< where it leads; empty: nowhere
};

/// Rows of a table below a heading of their own; they are sorted by themselves.
struct HtmlGroup {
  std::string name;
  std::vector<std::vector<HtmlCell>> rows;
};
/// With as many digits as a reader needs.
HtmlCell html_number(double x);
/// "12.5 %", or "0" only for zero itself
HtmlCell html_share(double x);
HtmlCell html_bytes(double bytes);

/// What a page says of itself.
struct PageText {
  std::string title;
  std::vector<std::string> facts;  ///< model, view, machine, date, command
};

/// One HTML page that needs nothing else: light and dark as the system has it or by a button, tables sorted by the buttons in
/// their heads, all by keyboard.
class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void list(const std::vector<std::string>& items);
  void table(const std::vector<std::string>& columns, const std::vector<std::vector<HtmlCell>>& rows);
  void table(const std::vector<std::string>& columns, const std::vector<HtmlGroup>& groups,
             const std::string& style_class = "");
  /// An <svg> element that scrolls on a narrow screen, where its words would be too small.
  void diagram(const std::string& svg) { html("<div class=\"scroll diagram\" tabindex=\"0\">" + svg + "</div>\n"); }
  void style(std::string_view text) { html("<style>\n"), html(text), html("</style>\n"); }
  void html(std::string_view markup) { body_ += markup; }
  void script(std::string_view text) { script_ += text; }

  std::string text() const;

 private:
  void add_row(const std::vector<HtmlCell>& row);

  std::string title_, body_, script_;
};

}  // namespace hsr::internal
