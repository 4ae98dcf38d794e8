#include "hsr/cli/explained_pages.h"

#include "study/explain/explain_pages.h"

namespace hsr::cli {

void write_explained(OutputDirectory& directory, const std::string& prefix, const std::vector<ExplainedMethod>& methods,
                     const ExplainedScene* scene, int size, bool has_lessons) {
  const std::string made = std::string("Made by hsr ") + HSR_VERSION + ".";
  const std::vector<Lesson> lessons = has_lessons ? all_lessons(made) : std::vector<Lesson>();
  std::vector<std::string> names;
  for (const ExplainedMethod& m : methods) names.push_back(m.name);
  for (const Lesson& lesson : lessons) names.push_back(lesson.name);
  for (const ExplainedMethod& m : methods) {
    Trace trace = scene != nullptr ? m.explain(*scene, size) : example_trace(m, size);
    trace.method = m.name;
    trace.title = m.title;
    if (scene != nullptr) trace.view = scene->title;
    directory.write(prefix + m.name + ".json", trace_json(trace));
    directory.write(prefix + m.name + ".html", explain_page(m, trace, made, names));
  }
  for (const Lesson& lesson : lessons) directory.write(prefix + lesson.name + ".html", lesson.page);
  directory.write(prefix + "index.html", explain_index(methods, lessons, made));
}

}  // namespace hsr::cli
