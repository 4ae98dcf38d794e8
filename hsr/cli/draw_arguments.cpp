#include "hsr/cli/draw_arguments.h"

namespace hsr::cli {

namespace {

const char* const examples = R"(Examples:
  hsr draw part.stl -o part.svg                            iso view on A4
  hsr draw part.stl -o part.svg --hidden dashed            hidden lines dashed, on their own layers
  hsr draw part.obj -o front.svg -o front.png --view front --scale 1:2
  hsr draw house.glb -o house.svg --eye 20,15,30          glTF has y up, in metres
  hsr draw part.obj -o part.pdf -o part.dxf --view front   for a reader of papers, and for a CAD program
  hsr draw part.ply -o lines.json --edges all --exact      every edge, parameters as "p/q"
  hsr draw part.stl -o part.svg --fill                     filled, with the lines on top
  hsr draw part.stl -o part.svg -o errors.csv              and how wrong a z-buffer is, size by size, against its time
  hsr draw part.ply -o lines.json --hidden dashed --why    and which faces hide what
  hsr draw house.obj trees.stl -o x.svg --ghost trees.stl  one scene; the trees are drawn and hide nothing
  hsr draw part.stl -o part.svg --oblique 45,0.5           cabinet projection: the front stays true
  hsr draw house.obj -o plan.pdf --view top --section z=1.2  a plan: what is above is taken away, walls are hatched
  hsr draw part.stl -o part.svg --pen visible=0.35,hidden-sharp=0.18:#555 --hidden dashed --scale standard
  hsr draw part.stl -o part.hpgl --sort pen                for a plotter: short ways with the pen up
  hsr draw part.stl -o part.dxf --outline-only --view top  closed rings for a laser cutter
  hsr draw part.stl -o part.dxf --view front --fit-arcs 0.05  holes as circles, where the edges of the model lie on some
  zcat part.obj.gz | hsr draw - -o svg:- > part.svg        from standard input to standard output

Writes each FILE, all of them or none: .svg, .pdf, .eps, .tex (TikZ), .hpgl (or .plt) and .png show the lines on a page, .dxf has
them in units of the model, 1:1, whatever the page; .json has every line with its visible and its
hidden intervals; .csv is a table of errors against run time. Standard error tells what was written, and the scale of a page.
Exit status 1: --check or a csv found a difference that must not be.)";

void add_line_options(DrawArguments& a, Options& options) {
  options.begin_group("Lines");
  options.add("--hidden", a.hidden, "STYLE", "Hidden lines: none, dashed or solid")
      .with_default_shown()
      .one_of({"none", "dashed", "solid"});
  a.lines.add_to(options);
  options
      .add("--overhead", a.overhead, "STYLE",
           "What the section takes away, as it is seen from the cut: dashed, in the class overhead, or off. In parallel views")
      .with_default_shown()
      .one_of({"dashed", "off"});
  options.add_flag("--section-each", a.section_each,
                   "A drawing for each --section, numbered in their order: plan-1.svg, plan-2.svg");
  options.add_flag("--why", a.why, "JSON: which faces hide each hidden interval");
}

void add_surface_options(DrawArguments& a, Options& options) {
  options.begin_group("Surfaces");
  options.add_flag("--fill", a.fill, "Fill the visible parts of faces, in the file's colours or grey; JSON: with fragments");
  a.fills.add_shade_to(options);
  options.add_flag(
      "--outline-only", a.outline_only,
      "Instead of lines and fills: the outline of everything, with holes, as closed rings, such as for laser cutting");
  a.fills.add_merge_to(options);
  options.add_flag(
      "--check", a.check,
      "Compare the visible fragments with the nearest face at each sample of --size [1024x1024], exit status 1 if they "
      "differ; and z-buffers, with the reason for each difference, those of the driver's OpenGL last");
}

}  // namespace

Options DrawArguments::add_to(CommandLine& command) {
  Options options =
      command.add_verb("draw", "Draw the visible lines of models: SVG, PDF, EPS, DXF, TikZ, HPGL, PNG or JSON", examples);
  models.add_to(options);
  options
      .add_one_each(
          "-o,--output", outputs, "FILE",
          "The drawing; its ending chooses svg, pdf, eps, dxf, tex, hpgl, png or json; csv: a table of error against run time, "
          "of the "
          "exact fragments and of z-buffers of 256, 512, ... samples each way, up to --size [8192]; svg:- and the like "
          "write to standard output; may be repeated")
      .required();
  models.add_objects_to(options);
  view.add_to(options);
  scene.add_to(options);
  add_line_options(*this, options);
  add_surface_options(*this, options);
  page.add_to(options, "PNG: pixels [150 to the inch]; --check and csv: samples");
  page.add_pens_to(options);
  page.add_sort_to(options);
  page.add_fit_arcs_to(options);
  formats.add_dxf_to(options);
  formats.add_id_prefix_to(options);
  formats.add_exact_to(options);
  common.add_threads_to(options);
  options
      .add("--arithmetic", arithmetic, "KIND",
           "staged (exact, fast), or for comparison double (may be wrong!), interval, rational")
      .with_default_shown()
      .one_of({"staged", "double", "interval", "rational"});
  options.begin_group("Report");
  common.add_report_to(options, "Times, counts and decisions");
  common.add_quiet_to(options, "Say nothing but what is wrong");
  return options;
}

}  // namespace hsr::cli
