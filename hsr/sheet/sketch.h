#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// Which point of a text is placed, on its base line.
enum class Anchor : std::uint8_t { left, middle, right };

/// How a text runs: to the right, or upwards, to be read from the right of the sheet (ISO 129-1).
enum class Reading : std::uint8_t { across, upwards };

/// What of a page is no picture of a model: frames, text, dimensions. Lines in named layers, in mm of the page, y down.
class Sketch {
 public:
  using LayerIndex = std::size_t;

  /// The layer of that name, made by the first who asks for it.
  LayerIndex layer(const std::string& name, const Pen& pen);

  void line(LayerIndex layer, const Point2& from, const Point2& to) { polyline(layer, std::array{from, to}, false); }
  /// In parts, where it would run through a text that is there already or nearly touch it.
  void line_beside_texts(LayerIndex layer, const Point2& from, const Point2& to);
  void polyline(LayerIndex layer, std::span<const Point2> points, bool closed);
  void rectangle(LayerIndex layer, const PaperFrame& frame);
  void circle(LayerIndex layer, const Point2& centre, double radius);
  /// A narrow head that strokes of the layer's pen fill.
  /// @param direction of length 1, toward the tip
  void arrow_head(LayerIndex layer, const Point2& tip, const Point2& direction, double length);
  /// In the layer "GROUP text HEIGHT", in tenths of a millimetre, with a pen of a tenth of the height. What is wider than `widest` is
  /// written narrower.
  void text(const std::string& group, std::string_view text, double height, const Point2& at, Anchor anchor = Anchor::left,
            Reading reading = Reading::across, double widest = 1e9);

  /// Adds the layers after those that are there.
  void append_to(Drawing& drawing) const;

 private:
  struct Stroke {
    std::vector<Point2> points;
    bool closed = false;
    double radius = 0;  ///< more than 0: a whole circle around `centre`, that the points lie on
    Point2 centre = {};
  };
  struct Layer {
    std::string name;
    Pen pen;
    std::vector<Stroke> strokes;
  };

  std::vector<Layer> layers_;
  std::vector<PaperFrame> texts_;  // around each
};

/// A narrow or wide continuous pen, and the chain of centre lines (ISO 128-20, 04.1).
Pen continuous_pen(double width);
Pen chain_pen(double width);

}  // namespace hsr::internal
