#include "study/html_page.h"

#include <array>
#include <charconv>
#include <cmath>

#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

constexpr std::string_view style = R"(
:root{--ink:#1d2026;--paper:#fff;--faint:#dcdfe4;--panel:#f5f6f8;--link:#2456b3;
--c0:#3566c4;--c1:#c4472b;--c2:#2b8a57;--c3:#8a4fbf;--c4:#b07a10;--c5:#15879b;--c6:#b8397f;--c7:#6b6f76;color-scheme:light}
:root[data-theme=dark]{--ink:#e4e6ea;--paper:#15171b;--faint:#383c44;--panel:#1e2126;--link:#8db4ff;
--c0:#7ea6f5;--c1:#f08a70;--c2:#63c791;--c3:#c295ee;--c4:#dcae4a;--c5:#5cc3d4;--c6:#ee86bb;--c7:#a7acb5;color-scheme:dark}
*{box-sizing:border-box}
body{margin:0 auto;max-width:76rem;padding:1rem 1.25rem 4rem;font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper)}
h1{font-size:1.5rem;margin:.5rem 0}h2{font-size:1.15rem;margin:2rem 0 .5rem}p{max-width:60rem}
header{display:flex;gap:1rem;align-items:baseline;justify-content:space-between;flex-wrap:wrap}
button,select,input{font:inherit;color:inherit}
button{background:var(--panel);border:1px solid var(--faint);border-radius:4px;padding:.1rem .5rem;cursor:pointer}
:focus-visible{outline:2px solid var(--link);outline-offset:1px}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:13.5px}td,th{padding:.2rem .6rem;border-bottom:1px solid var(--faint);text-align:left;white-space:nowrap}
td.t{white-space:normal;min-width:22rem}td.n{text-align:right;font-variant-numeric:tabular-nums}th button{border:0;background:none;padding:0;font-weight:600}
th[aria-sort=ascending] button::after{content:" \2191"}th[aria-sort=descending] button::after{content:" \2193"}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(30rem,1fr));gap:1rem}
.plots svg{width:100%;height:auto;border:1px solid var(--faint);border-radius:4px}
@media(max-width:34rem){.plots{grid-template-columns:1fr}}
)";

constexpr std::string_view behaviour = R"(
const root=document.documentElement,themes=document.getElementById('theme');
const dark=matchMedia('(prefers-color-scheme: dark)');
let chosen='';
function paint(){root.dataset.theme=chosen||(dark.matches?'dark':'light');themes.textContent=root.dataset.theme=='dark'?'Light':'Dark'}
themes.addEventListener('click',()=>{chosen=root.dataset.theme=='dark'?'light':'dark';paint()});
dark.addEventListener('change',paint);paint();
for(const table of document.querySelectorAll('table'))table.querySelectorAll('th button').forEach((button,column)=>
button.addEventListener('click',()=>{const head=button.parentElement,up=head.getAttribute('aria-sort')!='ascending';
for(const h of table.querySelectorAll('th'))h.removeAttribute('aria-sort');
head.setAttribute('aria-sort',up?'ascending':'descending');
const rows=[...table.tBodies[0].rows],key=r=>{const c=r.cells[column];return 'v' in c.dataset?+c.dataset.v:c.textContent};
rows.sort((a,b)=>{const x=key(a),y=key(b);const d=typeof x=='number'&&typeof y=='number'?x-y:String(x).localeCompare(String(y));return up?d:-d});
table.tBodies[0].append(...rows)}));
)";

}  // namespace

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
  constexpr std::size_t longest = 40;  // a text that stays on one line
  body_ += "<div class=\"scroll\" tabindex=\"0\"><table><thead><tr>";
  for (const std::string& c : columns) body_ += "<th scope=\"col\"><button>" + html_escaped(c) + "</button></th>";
  body_ += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    body_ += "<tr>";
    for (const HtmlCell& c : row)
      body_ += (c.is_number               ? "<td class=\"n\" data-v=\"" + rounded_text(c.value, 17) + "\">"
                : c.text.size() > longest ? "<td class=\"t\">"
                                          : "<td>") +
               html_escaped(c.text) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

std::string HtmlPage::text() const {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + html_escaped(title_) +
                    "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>";
  out += style;
  out += "</style></head><body>\n<header><h1>" + html_escaped(title_) +
         "</h1><button id=\"theme\" aria-label=\"Change between light and dark\"></button></header>\n";
  out += body_;
  out += "<script>";
  out += behaviour;
  out += script_;
  return out + "</script></body></html>\n";
}

}  // namespace hsr::internal
