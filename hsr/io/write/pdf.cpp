#include "hsr/io/write/pdf.h"

#include <zlib.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/line_paths.h"
#include "hsr/io/write/painted_paths.h"
#include "hsr/io/write/svg_text.h"
#include "hsr/utf8.h"

namespace hsr::internal {

namespace {

constexpr double longest_side = 5080;  // mm: 14400 points, the limit of PDF 1.5

std::string deflated(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string out(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                               text.size(), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw InputError("pdf: the drawing does not fit into memory");
  out.resize(size);
  return out;
}

/// Numbered objects, from 1 on, and at the end where each of them begins.
class PdfFile {
 public:
  PdfFile() : text_("%PDF-1.5\n%\xE2\xE3\xCF\xD3\n") {}

  /// A number for an object that is written later.
  std::size_t reserve() {
    starts_.push_back(0);
    return starts_.size();
  }
  void write(std::size_t number, const std::string& body) {
    starts_[number - 1] = text_.size();
    append_integer(text_, number);
    text_ += " 0 obj\n" + body + "\nendobj\n";
  }
  void write_stream(std::size_t number, const std::string& keys, const std::string& contents) {
    const std::string bytes = deflated(contents);
    write(number, "<< " + keys + "/Filter /FlateDecode /Length " + std::to_string(bytes.size()) + " >>\nstream\n" + bytes +
                      "\nendstream");
  }
  std::string finish(std::size_t root, std::size_t info) {
    const std::size_t table = text_.size();
    const std::string size = std::to_string(starts_.size() + 1);
    text_ += "xref\n0 " + size + "\n0000000000 65535 f \n";
    for (const std::size_t start : starts_) {
      const std::string digits = std::to_string(start);
      if (digits.size() > 10) throw InputError("pdf: the file would be 10 GB or more, expected less");
      text_ += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
    }
    text_ += "trailer\n<< /Size " + size + " /Root " + std::to_string(root) + " 0 R /Info " + std::to_string(info) +
             " 0 R >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return std::move(text_);
  }

 private:
  std::string text_;
  std::vector<std::size_t> starts_;
};

std::string reference(std::size_t number) { return std::to_string(number) + " 0 R "; }

/// A text string: UTF-16 in hexadecimal digits, which carries any text.
std::string text_string(const std::string& text) {
  std::string out = "<FEFF";
  const auto append_unit = [&](std::uint32_t unit) {
    for (int shift = 12; shift >= 0; shift -= 4) out += "0123456789ABCDEF"[unit >> shift & 15U];
  };
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = utf8_character(text, i);
    i += c.bytes > 0 ? c.bytes : 1;
    if (c.bytes > 0 && c.code >= 0x10000) {
      append_unit(0xD800 + ((c.code - 0x10000) >> 10));
      append_unit(0xDC00 + ((c.code - 0x10000) & 0x3FFU));
    } else {
      append_unit(c.bytes > 0 ? c.code : 0xFFFD);
    }
  }
  return out + ">";
}

/// Layers of the page, and within them those of objects: optional content groups.
class PdfLayers {
 public:
  PdfLayers(PdfFile& file, const std::vector<std::string>& objects) : file_(file), objects_(objects) {}

  /// What follows in `contents` is of this layer, until its end; layers have the names of the SVG's.
  void begin(std::string& contents, const std::string& name) { layers_.push_back({group(contents, "(" + name + ")"), {}}); }
  /// What follows is of this object of the layer that was begun last. Objects without a name have no group.
  void begin_object(std::string& contents, std::uint32_t object) {
    if (object < objects_.size() && objects_[object].empty()) object = SceneObjects::none;
    if (object == open_) return;
    end_object(contents);
    open_ = object;
    if (object != SceneObjects::none) layers_.back().objects.push_back(group(contents, text_string(objects_[object])));
  }
  void end(std::string& contents) {
    end_object(contents);
    contents += "EMC\n";
  }

  bool are_there() const { return !layers_.empty(); }
  std::string all() const {
    std::string out;
    for (const std::size_t g : groups_) out += reference(g);
    return out;
  }
  /// As a reader lists them, what is drawn last first, objects under their layers.
  std::string order() const {
    std::string out;
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
      out += reference(layer->group);
      if (layer->objects.empty()) continue;
      out += "[ ";
      for (const std::size_t g : layer->objects) out += reference(g);
      out += "] ";
    }
    return out;
  }
  /// The names by which the contents call them: /L0, /L1, ...
  std::string properties() const {
    std::string out;
    for (std::size_t k = 0; k < groups_.size(); ++k) out += "/L" + std::to_string(k) + " " + reference(groups_[k]);
    return out;
  }

 private:
  struct NestedLayer {
    std::size_t group;
    std::vector<std::size_t> objects;
  };

  std::size_t group(std::string& contents, const std::string& name) {
    contents += "/OC /L" + std::to_string(groups_.size()) + " BDC\n";
    groups_.push_back(file_.reserve());
    file_.write(groups_.back(), "<< /Type /OCG /Name " + name + " >>");
    return groups_.back();
  }
  void end_object(std::string& contents) {
    if (open_ != SceneObjects::none) contents += "EMC\n";
    open_ = SceneObjects::none;
  }

  PdfFile& file_;
  const std::vector<std::string>& objects_;
  std::vector<std::size_t> groups_;
  std::vector<NestedLayer> layers_;
  std::uint32_t open_ = SceneObjects::none;
};

/// The contents of the page, and what they refer to.
class PdfPage {
 public:
  PdfPage(PdfFile& file, const Drawing& drawing) : file_(file), layers_(file, drawing.objects) {
    append_page_space(contents_, drawing.height);
    if (!drawing.fills.fills.empty()) {
      layers_.begin(contents_, "fill");
      append_fills(contents_, drawing.fills, drawing.pens,
                   [&](const std::string& contents, const PaperFrame& box) { return sheet(contents, box); });
      opacities_[name_of_opacity(1)] = 1;
      layers_.end(contents_);
      for (const Fill& fill : drawing.fills.fills) opacities_[name_of_opacity(fill.opacity)] = fill.opacity;
    }
    for (const Layer& layer : layers_of(drawing)) {
      layers_.begin(contents_, layer.name());
      append_pen(contents_, layer.pen);
      for (const Polyline& p : layer.polylines) {
        layers_.begin_object(contents_, p.object);
        append_line(contents_, drawing, p, layer.pen);
      }
      layers_.end(contents_);
    }
  }

  const std::string& contents() const { return contents_; }
  const PdfLayers& layers() const { return layers_; }
  std::string resources() const {
    std::string out = "<< /Properties << " + layers_.properties() + ">> ";
    if (!sheets_.empty()) out += "/XObject << ";
    for (std::size_t k = 0; k < sheets_.size(); ++k) out += "/S" + std::to_string(k) + " " + reference(sheets_[k]);
    if (!sheets_.empty()) out += ">> ";
    if (opacities_.empty()) return out + ">>";
    out += "/ExtGState << ";
    for (const auto& [name, opacity] : opacities_) {
      out += name + " << /ca ";
      append_length(out, std::round(opacity * 1000) / 1000);
      out += " >> ";
    }
    return out + ">> >>";
  }

 private:
  /// A transparency group, which the page takes as one object.
  std::string sheet(const std::string& contents, const PaperFrame& bounds) {
    std::string box = "[";
    for (const double x : {bounds.left, bounds.top, bounds.right, bounds.bottom}) {
      append_length(box, x);
      box += ' ';
    }
    sheets_.push_back(file_.reserve());
    file_.write_stream(sheets_.back(),
                       "/Type /XObject /Subtype /Form /Group << /S /Transparency /CS /DeviceRGB >> /BBox " + box + "] ",
                       contents);
    return "/S" + std::to_string(sheets_.size() - 1) + " Do\n";
  }

  PdfFile& file_;
  std::string contents_;
  PdfLayers layers_;
  std::vector<std::size_t> sheets_;
  std::map<std::string, double> opacities_;
};

}  // namespace

std::string pdf(const Drawing& drawing, const std::string& title) {
  if (!(drawing.width <= longest_side) || !(drawing.height <= longest_side)) {
    std::string found;
    append_length(found, drawing.width);
    found += " x ";
    append_length(found, drawing.height);
    throw InputError("pdf: found a page of " + found + " mm, expected at most 5080 mm either way");
  }
  PdfFile file;
  const std::size_t root = file.reserve(), info = file.reserve(), pages = file.reserve(), page = file.reserve(),
                    contents = file.reserve();
  const PdfPage drawn(file, drawing);
  std::string layers;
  if (drawn.layers().are_there())
    layers = " /OCProperties << /OCGs [ " + drawn.layers().all() + "] /D << /Order [ " + drawn.layers().order() + "] >> >>";
  file.write(root, "<< /Type /Catalog /Pages " + reference(pages) + layers + " >>");
  file.write(info, "<< /Title " + text_string(title) + " /Producer (hsr) >>");
  file.write(pages, "<< /Type /Pages /Count 1 /Kids [ " + reference(page) + "] >>");
  std::string box = "[0 0 ";
  append_length(box, points_of(drawing.width));
  box += ' ';
  append_length(box, points_of(drawing.height));
  file.write(page, "<< /Type /Page /Parent " + reference(pages) + "/MediaBox " + box + "] /Contents " + reference(contents) +
                       "/Resources " + drawn.resources() + " >>");
  file.write_stream(contents, "", drawn.contents());
  return file.finish(root, info);
}

}  // namespace hsr::internal
