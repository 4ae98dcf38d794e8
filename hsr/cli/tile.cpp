#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <memory>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/tile_job.h"

namespace hsr::cli {

namespace {

struct TileArguments {
  std::string job;
  std::vector<std::string> numbers;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr tile job 3                                           the lines of the third tile
  parallel hsr tile job ::: $(seq 16)                      all of sixteen, as many at once as there are processors

Writes JOB/part-N under a temporary name, syncs it and renames it: it is there whole or not at all. Where it is there, and of this job,
nothing is done. Any number of tiles may be done at once, anywhere that sees the directory, and again. hsr join makes the drawing.)";

std::uint32_t parse_number(const std::string& text, std::size_t tiles) {
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size() || n < 1 || n > tiles)
    throw InputError(fmt::format("N: found \"{}\", expected the number of a tile from 1 to {}", text, tiles));
  return n - 1;
}

void run(const TileArguments& a, UnfinishedFiles& unfinished) {
  CommandContext context(a.common, {}, {}, unfinished);
  const TileJob job = read_job(a.job);
  std::vector<std::uint32_t> numbers;
  for (const std::string& text : a.numbers) numbers.push_back(parse_number(text, job.tiles.size()));
  for (const std::uint32_t tile : numbers) {
    if (!wrong_with_part(job, tile)) {
      if (!context.is_quiet()) tell("hsr: {}: done before\n", job.part_path(tile));
      continue;
    }
    TileRequest request = job.request();
    request.lines.progress = [&](double done) { context.progress.show(done); };
    context.progress.stage("visible lines");
    const auto start = std::chrono::steady_clock::now();
    const TilePart part = [&] {
      const ModelPart model = read_tile(job, tile);
      return lines_of_tile(model, job.chosen.view, job.image, tile, request);
    }();
    write_part(job, tile, part, unfinished);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    context.progress.clear();
    context.report.set(
        fmt::format("tile {}", tile + 1),
        {{"faces", job.tiles[tile].faces}, {"pieces", part.pieces.size()}, {"pairs", part.pairs}, {"seconds", seconds}});
    if (!context.is_quiet())
      tell("hsr: {}: {}, {}, {} pairs, {:.2f} s\n", job.part_path(tile), counted(job.tiles[tile].faces, "face"),
           counted(part.pieces.size(), "piece"), part.pairs, seconds);
  }
  context.finish();
}

}  // namespace

void add_tile(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<TileArguments>();
  Options options =
      command.add_verb("tile", "Find the lines and fills of one tile, or some, of what hsr split has made", examples);
  options.add("JOB", a->job, "JOB", "The directory that hsr split has made").required();
  options.add_several("N", a->numbers, "Numbers of tiles, from 1 on").required();
  a->common.add_threads_to(options);
  a->common.add_report_to(options, "Times and counts of each tile");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
