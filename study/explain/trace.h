#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal {

/// A place in the picture, in its units: x to the right, y down.
using TracePlace = std::array<double, 2>;
using TraceRing = std::vector<TracePlace>;

/// Something in a list of the state, and the face in whose colour it is shown; -1: none.
struct TraceItem {
  std::string text;
  int face = -1;
};

/// A part of a line, in its parameter, and what it is of; -1: no face.
struct TraceBar {
  double from, to;
  int face = -1;
};

/// A straight line of the picture.
struct TraceLine {
  TracePlace from, to;
  bool is_hidden = false;
};

/// A sample of a picture, what stands in it and whose it is; -1: nobody's. It has the colour of the face, or one of its own.
struct TraceCell {
  int column, row;
  std::string text;
  int face = -1;
  std::optional<Colour> colour = {};
};

/// Which of some samples a face covers: rows of '0' and '1'.
struct TraceMask {
  std::string text;
  int face = -1;
  std::vector<std::string> rows = {};
};

/// Tiles that divide the picture: tile (i, j) reaches from corner + i column + j row to a column and a row on.
struct TraceTiles {
  TracePlace corner, column, row;
  int columns = 0, rows = 0;
  /// By rows: the depth beyond which a tile hides everything; infinite: it hides nothing.
  std::vector<double> depths;
};

/// A tile that is looked at, and whether it hides what is asked about.
struct TraceTile {
  int column, row;
  bool hides;
};

/// What happens next? One of the choices is right.
struct TraceQuestion {
  std::string question;
  std::vector<std::string> choices;
  std::size_t right = 0;
};

/// One step of a method: what it does, in a sentence, and how the state changes by it. Each function returns the step, so that they can
/// be called in a row. Member of a TraceRun; docs/explain.md says what each of them is in JSON.
class TraceStep {
 public:
  TraceStep(std::string kind, std::string line, std::string says)
      : kind_(std::move(kind)), line_(std::move(line)), says_(std::move(says)) {}

  TraceStep& number(const std::string& name, double value);
  TraceStep& number(const std::string& name, const std::string& value);
  // What is looked at, in this step alone.
  TraceStep& face(std::uint32_t face);
  TraceStep& piece(std::uint32_t piece);
  TraceStep& edge(std::uint32_t edge);
  TraceStep& mark(const TraceLine& line);
  TraceStep& row(int row);
  TraceStep& tile(const TraceTile& tile);
  // The state from now on.
  TraceStep& list(const std::string& name, const std::vector<TraceItem>& items);
  TraceStep& add(const std::string& list, const TraceItem& item);
  TraceStep& drop(std::uint32_t piece);
  TraceStep& make_piece(std::uint32_t piece, std::uint32_t face, const std::string& name, const TraceRing& ring);
  TraceStep& paint(std::uint32_t piece);
  TraceStep& unpaint();  ///< all of it
  TraceStep& cells(const std::vector<TraceCell>& cells);
  TraceStep& tiles(const TraceTiles& tiles);
  TraceStep& masks(const std::string& name, const std::vector<TraceMask>& masks);
  TraceStep& node(std::uint32_t node, int parent, bool is_before, const std::string& text, int face);
  TraceStep& bars(const std::string& name, const std::vector<TraceBar>& bars);
  TraceStep& draw(const std::vector<TraceLine>& lines);
  TraceStep& undraw();  ///< all of it
  TraceStep& ask(TraceQuestion question);

  /// What it says, where that is known only later.
  TraceStep& says(std::string sentence) {
    says_ = std::move(sentence);
    return *this;
  }
  const std::string& line() const { return line_; }
  bool asks() const { return !question_.choices.empty(); }
  void append_to(std::string& json) const;

 private:
  std::string& change(const char* what);
  void end_change() { changes_ += '}'; }

  std::string kind_, line_, says_;
  std::vector<std::pair<std::string, std::variant<double, std::string>>> numbers_;
  std::vector<std::uint32_t> faces_, pieces_, edges_;
  std::vector<TraceLine> marks_;
  std::vector<TraceTile> tiles_;
  int row_ = -1;
  std::string changes_;  // JSON, objects with commas between
  TraceQuestion question_;
};

struct TracedFace {
  std::string name;
  Colour colour;
  std::vector<TraceRing> rings;
};

struct TracedEdge {
  TracePlace from, to;
  std::string name;
};

/// What all steps are about.
struct TracedScene {
  double width = 0, height = 0;  ///< of the picture
  bool has_samples = false;      ///< each unit of it is a sample: cell (i, j) from (i, j) to (i + 1, j + 1)
  std::vector<TracedFace> faces;
  std::vector<TracedEdge> edges;
};

/// The steps of one run of a method, and what it gave.
struct TraceRun {
  std::string name;
  std::optional<TracedScene> scene = {};  ///< where it is not that of the trace
  std::deque<TraceStep> steps;            // references to steps stay good
  /// What the library returned, apart from the steps: their end must come to the same.
  std::string result = "{}";  ///< JSON

  TraceStep& step(std::string kind, std::string line, std::string says) {
    return steps.emplace_back(std::move(kind), std::move(line), std::move(says));
  }
};

/// A method step by step, as it ran.
struct Trace {
  std::string method, title, view;
  TracedScene scene;
  std::string pseudocode;  ///< by lines, "name|text"
  std::vector<TraceRun> runs;

  TraceRun& run(const std::string& name) {
    runs.emplace_back().name = name;
    return runs.back();
  }
};

/// "hsr-trace/1" (docs/explain.md).
std::string trace_json(const Trace& trace);

/// What a step says of a number: "0.25", "-3", "65535", "1.3e-05".
std::string trace_text(double x);

}  // namespace hsr::internal
