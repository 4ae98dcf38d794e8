#include "hsr/cli/format_arguments.h"

namespace hsr::cli {

void FormatArguments::add_dxf_to(Options& options) {
  options.add("--dxf", dxf_release, "RELEASE", "DXF: r12, which everything reads, or 2000, with line weights")
      .with_default_shown()
      .one_of({"r12", "2000"});
}

void FormatArguments::add_id_prefix_to(Options& options) {
  options.add("--id-prefix", id_prefix, "TEXT", "SVG: what each id begins with, for several files in one document");
}

void FormatArguments::add_exact_to(Options& options, const std::string& help) {
  options.begin_group("Numbers");
  options.add_flag("--exact", exact, help);
}

}  // namespace hsr::cli
