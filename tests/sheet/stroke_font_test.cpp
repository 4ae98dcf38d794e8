#include "hsr/sheet/stroke_font.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "hsr/sheet/glyphs.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

struct Box {
  double left = HUGE_VAL, right = -HUGE_VAL, top = HUGE_VAL, bottom = -HUGE_VAL;
};

Box box_of(const std::vector<TextStroke>& strokes) {
  Box box;
  for (const TextStroke& stroke : strokes)
    for (const Point2& p : stroke)
      box = {std::min(box.left, p.x), std::max(box.right, p.x), std::min(box.top, p.y), std::max(box.bottom, p.y)};
  return box;
}

std::vector<TextStroke> written(const std::string& text) { return StrokeFont(10).strokes(text, {0, 0}); }

}  // namespace

TEST_CASE("Every letter of ASCII can be written, within its width and height", "[sheet][font]") {
  for (char c = '!'; c <= '~'; ++c) {
    const std::string letter(1, c);
    CAPTURE(letter);
    CHECK(StrokeFont::knows(letter));
    const auto strokes = written(letter);
    REQUIRE_FALSE(strokes.empty());
    for (const TextStroke& stroke : strokes) CHECK(stroke.size() >= 2);
    const Box box = box_of(strokes);
    CHECK(box.left >= -0.2);
    CHECK(box.right <= StrokeFont(10).width(letter) + 0.2);
    CHECK(box.top >= -11.5);
    CHECK(box.bottom <= 3.1);
  }
}

TEST_CASE("Capitals and digits are as high as the font, small letters 0.7 of it", "[sheet][font][L7]") {
  for (const char c : std::string("ABCDEFGHIJKLMNOPRSTUVWXYZ0123456789bdfhklt")) {
    CAPTURE(c);
    const Box box = box_of(written(std::string(1, c)));
    CHECK(box.top == Approx(-10).margin(0.15));
    CHECK(box.bottom == Approx(0).margin(0.15));
  }
  for (const char c : std::string("acemnorsuvwxz")) {
    CAPTURE(c);
    const Box box = box_of(written(std::string(1, c)));
    CHECK(box.top == Approx(-7).margin(0.15));
    CHECK(box.bottom == Approx(0).margin(0.15));
  }
  for (const char c : std::string("gjpqy")) CHECK(box_of(written(std::string(1, c))).bottom > 2.5);
}

TEST_CASE("Letters with marks have the letter and the mark, over it or under it", "[sheet][font]") {
  for (const char* letter : {"Ä", "ö", "ü", "é", "ñ", "å", "Š", "ž", "ő", "ė"}) {
    CAPTURE(letter);
    CHECK(StrokeFont::knows(letter));
    CHECK(box_of(written(letter)).top < -8);
  }
  CHECK(box_of(written("Ä")).top < box_of(written("A")).top - 1);
  CHECK(written("Ä").size() == written("A").size() + 2);
  CHECK(box_of(written("ç")).bottom > 1);
  CHECK(StrokeFont(10).width("ü") == StrokeFont(10).width("u"));
  // Of an i with two dots, not three.
  CHECK(written("ï").size() == 3);
}

TEST_CASE("A box stands for a letter that the font does not have, and for bytes that are none", "[sheet][font][L7]") {
  CHECK(StrokeFont::knows("Ø25 ±0,1 – 30° ⌀ µm"));
  for (const std::string text : {"漢", "\xFF", "\xC3"}) {
    CHECK_FALSE(StrokeFont::knows(text));
    REQUIRE(written(text).size() == 1);
    CHECK(written(text)[0].size() == 5);
  }
}

TEST_CASE("Text is as wide as its letters and the gaps between", "[sheet][font]") {
  const StrokeFont font(3.5);
  CHECK(font.width("") == 0);
  CHECK(font.width("HH") == Approx(2 * font.width("H") + 0.7));
  const Box box = box_of(font.strokes("HaH", {20, 30}));
  CHECK(box.left == Approx(20));
  CHECK(box.right == Approx(20 + font.width("HaH")));
  CHECK(box.top == Approx(26.5));
  CHECK(box.bottom == Approx(30));
}

TEST_CASE("Each letter that is looked up is found under its own code", "[sheet][font]") {
  for (char32_t code = 0x20; code < 0x2400; ++code) {
    if (const Glyph* glyph = glyph_of(code)) CHECK(glyph->code == code);
    const AccentedGlyph accent = accented_glyph(code);
    if (accent.code == 0) continue;
    CAPTURE(static_cast<std::uint32_t>(code));
    CHECK(accent.code == code);
    CHECK(glyph_of(accent.base) != nullptr);
    CHECK(mark_glyph(accent.mark) != nullptr);
    CHECK(glyph_of(code) == nullptr);
  }
  for (const char32_t code : {U'ß', U'Ø', U'°', U'±', U'×', U'µ', U'–', U'⌀', U'€', U'Æ', U'Ł'})
    CHECK(glyph_of(code) != nullptr);
}
