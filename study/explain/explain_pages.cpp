#include "study/explain/explain_pages.h"

#include <algorithm>

#include "geometry/error.h"
#include "study/html_page.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

void replace(std::string& text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw InvariantError("explain: a page without " + std::string(what));
  text.replace(at, what.size(), with);
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

/// JSON within HTML: no "</script>" and no "<!--" in it.
std::string data_element(const std::string& json) {
  std::string text = json;
  replace_all(text, "<", "\\u003c");
  return "<script class=\"trace\" type=\"application/json\">" + text + "</script>\n";
}

/// A link to a page that is not there is its text.
std::string with_links(std::string text, const std::vector<std::string>& pages) {
  constexpr std::string_view begin = "<a href=\"", ending = ".html\">", close = "</a>";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::size_t name = at + begin.size(), end = text.find(ending, name), closed = text.find(close, end);
    if (closed == std::string::npos) break;
    if (std::find(pages.begin(), pages.end(), text.substr(name, end - name)) != pages.end()) continue;
    text.erase(closed, close.size());
    text.erase(at, end + ending.size() - at);
  }
  return text;
}

std::string page(const std::string& title, const std::string& body, const std::string& made, bool has_players) {
  std::string text(page_text("explain.html"));
  replace(text, "{{style}}", page_text("explain.css"));
  replace_all(text, "{{title}}", html_escaped(title));
  replace(text, "{{data}}", "");
  replace(text, "{{made}}", html_escaped(made));
  std::string script(page_text("theme.js"));
  if (has_players)
    for (const char* const part : {"state.js", "labels.js", "diagrams.js", "player.js", "gaps.js"}) script += page_text(part);
  replace(text, "{{script}}", script);
  replace(text, "{{body}}", body);
  return text;
}

}  // namespace

std::string explain_page(const ExplainedMethod& method, const Trace& trace, const std::string& made,
                         const std::vector<std::string>& beside) {
  std::string body = with_links(std::string(page_text(method.name + ".about.html")), beside);
  body += "<p>" + html_escaped("Scene: " + trace.view) + "</p>\n" + data_element(trace_json(trace));
  return page(method.title, body, made, true);
}

std::string lesson_page(const std::string& title, std::string_view text,
                        const std::vector<std::pair<std::string, std::string>>& traces, const std::string& made) {
  std::string body = "<div class=\"lesson\">" + std::string(text) + "</div>";
  for (const auto& [name, json] : traces) replace(body, "{{trace:" + name + "}}", data_element(json));
  return page(title, body, made, true);
}

std::string explain_index(const std::vector<ExplainedMethod>& methods, const std::vector<Lesson>& lessons,
                          const std::string& made) {
  std::string body = "<p>What is visible, and how programs find out: each page shows one method step by step, as it ran.</p>\n";
  const auto add = [&](const std::string& name, const std::string& title, const std::string& about) {
    body += "<li><a href=\"" + name + ".html\">" + html_escaped(title) + "</a>: " + html_escaped(about) + "</li>\n";
  };
  if (!lessons.empty()) {
    body += "<h2>Lessons</h2>\n<p>The first two are to be read in order, in an hour.</p>\n<ol class=\"methods\">\n";
    for (const Lesson& lesson : lessons) add(lesson.name, lesson.title, lesson.about);
    body += "</ol>\n<h2>Methods</h2>\n";
  }
  body += "<ul class=\"methods\">\n";
  for (const ExplainedMethod& m : methods) add(m.name, m.title, m.about);
  return page("Visibility, step by step", body + "</ul>\n", made, false);
}

}  // namespace hsr::internal
