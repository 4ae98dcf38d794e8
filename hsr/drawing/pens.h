#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hsr/drawing/page.h"
#include "hsr/lines/line_options.h"
#include "hsr/model.h"

namespace hsr {

/// What becomes of hidden parts.
enum class HiddenLines : std::uint8_t { none, dashed, solid };

/// With what the lines of one visibility and one class are drawn.
struct Pen {
  double width = 0.5;  ///< mm
  Colour colour = {0, 0, 0, 255};
  std::vector<double> dashes = {};  ///< mm, dash and gap in turn, an even number; empty: continuous
  bool has_colour = false;          ///< one was asked for

  bool is_dashed() const { return !dashes.empty(); }
};

/// Dash and gap in turn, an even number of them; none: continuous.
struct DashSetting {
  std::vector<double> lengths = {};
  bool in_widths = false;  ///< of the line, else in mm
};

/// A pen as it was asked for; what is not said is left to what says less of which lines are meant.
struct PenSetting {
  std::optional<bool> hidden = {};  ///< nothing: visible and hidden lines
  std::optional<EdgeClass> edge_class = {};
  std::optional<double> width = {};  ///< mm
  std::optional<Colour> colour = {};
  std::optional<DashSetting> dash = {};
};

/// The pens of a drawing, by visibility and class.
class Pens {
 public:
  /// Those of ISO 128 in the line group of that width: what can be seen wide and continuous (01.2); what cannot half as wide and
  /// dashed (02.1); smooth edges, which a draughtsman calls imaginary, joints and hatching half as wide and continuous (01.1); borders of
  /// caps 1.4 times as wide, the next width of the series.
  explicit Pens(double wide = 0.5, HiddenLines hidden_lines = HiddenLines::dashed);

  const Pen& of(bool hidden, EdgeClass edge_class) const { return pens_[hidden ? 1 : 0][static_cast<std::size_t>(edge_class)]; }
  double wide() const { return wide_; }

  /// Each width, colour and dash is that of the setting that says most of which lines are meant: both visibility and class, else the
  /// class, else the visibility; of settings that say as much, of the last.
  void set(const std::vector<PenSetting>& settings);

 private:
  double wide_;
  std::array<std::array<Pen, edge_class_count>, 2> pens_;
};

/// The width of wide lines on that page, mm, of the line groups of ISO 128: by the longer side, 0.25 up to A6, 0.35 up to A5, 0.5 up to
/// A2, 0.7 up to A1, else 1. Pages of other sizes, which mostly are figures on a larger sheet, have 0.5 or more, and one that is cut to
/// its drawing 0.5.
double line_group(const Page& page);

/// "visible=0.35,hidden-sharp=0.18:#555:dashed": NAME=MM:COLOUR:DASH, of which any part may be missing. NAME is visible, hidden, a
/// class, or both of them as hidden-sharp. COLOUR is #rgb, #rrggbb or one of the 16 colours that HTML has names for. DASH is solid,
/// dashed (ISO 128 02.1), dotted (07) or chain (04.1), in widths of the line, or lengths in mm such as 3-0.75.
/// @throws InputError that names what was found and what is known
std::vector<PenSetting> parse_pens(const std::string& text);

/// The same, one setting to a line, with blanks anywhere; an empty line and what begins with "#" say nothing.
/// @param name of the file, for errors
std::vector<PenSetting> parse_pens_file(const std::string& contents, const std::string& name);

}  // namespace hsr
