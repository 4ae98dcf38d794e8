#include "study/html_page.h"

#include <array>
#include <charconv>
#include <cmath>

#include "hsr/io/write/svg_text.h"
#include "study/page_texts.h"

namespace hsr::internal {

std::string rounded_text(double x, int digits) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits);
  return {text.data(), end};
}

std::string short_text(double x) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), x);
  if (end - text.data() <= 6) return {text.data(), end};
  int power = 0;
  return std::frexp(x, &power) == 0.5 ? "2^" + std::to_string(power - 1) : rounded_text(x, 3);
}

std::string html_escaped(const std::string& text) {
  std::string out;
  append_text(out, text);
  return out;
}

std::string png_url(std::string_view png) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out = "data:image/png;base64,";
  out.reserve(out.size() + png.size() / 3 * 4 + 4);
  for (std::size_t k = 0; k < png.size(); k += 3) {
    const auto byte = [&](std::size_t m) -> unsigned { return m < png.size() ? static_cast<unsigned char>(png[m]) : 0U; };
    const unsigned bits = byte(k) << 16U | byte(k + 1) << 8U | byte(k + 2);
    for (unsigned m = 0; m < 4; ++m) out += k + m > png.size() ? '=' : letters[bits >> (18 - 6 * m) & 63U];
  }
  return out;
}

HtmlCell html_number(double x) { return {rounded_text(x, 3), x, true}; }

HtmlCell html_share(double x) { return {x == 0 ? "0" : rounded_text(100 * x, 3) + " %", x, true}; }

HtmlCell html_bytes(double bytes) {
  return {bytes < 1e6 ? rounded_text(bytes / 1e3, 3) + " kB" : rounded_text(bytes / 1e6, 3) + " MB", bytes, true};
}

void HtmlPage::heading(const std::string& text) { body_ += "<h2>" + html_escaped(text) + "</h2>\n"; }

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + html_escaped(text) + "</p>\n"; }

void HtmlPage::list(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += "<li>" + html_escaped(item) + "</li>\n";
  body_ += "</ul>\n";
}

void HtmlPage::table(const std::vector<std::string>& columns, const std::vector<std::vector<HtmlCell>>& rows) {
  table(columns, {{"", rows}});
}

void HtmlPage::table(const std::vector<std::string>& columns, const std::vector<HtmlGroup>& groups,
                     const std::string& style_class) {
  body_ += "<div class=\"scroll\" tabindex=\"0\"><table" + (style_class.empty() ? "" : " class=\"" + style_class + "\"") +
           "><thead><tr>";
  for (const std::string& c : columns) body_ += "<th scope=\"col\"><button>" + html_escaped(c) + "</button></th>";
  body_ += "</tr></thead>\n";
  for (const HtmlGroup& group : groups) {
    body_ += "<tbody>\n";
    if (!group.name.empty())
      body_ += "<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"" + std::to_string(columns.size()) + "\">" +
               html_escaped(group.name) + "</th></tr>\n";
    for (const auto& row : group.rows) add_row(row);
    body_ += "</tbody>";
  }
  body_ += "</table></div>\n";
}

void HtmlPage::add_row(const std::vector<HtmlCell>& row) {
  constexpr std::size_t longest = 24;  // a text that stays on one line
  body_ += "<tr>";
  for (const HtmlCell& c : row) {
    body_ += c.is_number               ? "<td class=\"n\" data-v=\"" + rounded_text(c.value, 17) + "\">"
             : c.text.size() > longest ? "<td class=\"t\">"
                                       : "<td>";
    body_ +=
        c.link.empty() ? html_escaped(c.text) : "<a href=\"" + html_escaped(c.link) + "\">" + html_escaped(c.text) + "</a>";
    body_ += "</td>";
  }
  body_ += "</tr>\n";
}

std::string HtmlPage::text() const {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + html_escaped(title_) +
                    "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>";
  out += page_text("report.css");
  out += "</style></head><body>\n<header><h1>" + html_escaped(title_) +
         "</h1><button id=\"theme\" aria-label=\"Change between light and dark\"></button></header>\n";
  out += body_;
  out += "<script>";
  out += page_text("report.js");
  out += script_;
  return out + "</script></body></html>\n";
}

}  // namespace hsr::internal
