#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hsr/io/write/dxf.h"
#include "hsr/io/write/layers.h"

namespace hsr::internal {

/// Group codes with their values, a line each. Release 2000 wants a handle for everything; release 12 none.
class DxfText {
 public:
  explicit DxfText(DxfVersion version) : version_(version) {}

  void add(int code, std::string_view value);
  void add(int code, std::int64_t value);
  void add_number(int code, double value);
  void add_point(double x, double y, int code = 10);  ///< z is 0
  /// What an entry or an entity begins with: its type, and in release 2000 a new handle and its owner. @return the handle
  std::uint64_t begin(std::string_view type, std::uint64_t owner = 0, int handle_code = 5);
  void add_class(std::string_view name);  ///< the subclass marker of release 2000
  void add_handle(int code, std::uint64_t handle);

  bool is_2000() const { return version_ == DxfVersion::r2000; }
  std::uint64_t next_handle() const { return handle_; }
  std::uint64_t take_handle() { return handle_++; }
  std::string text;

 private:
  DxfVersion version_;
  std::uint64_t handle_ = 1;
};

/// What a drawing covers, in units of the model, y up.
struct DxfExtent {
  double left = 0, bottom = 0, right = 0, top = 0;
};

/// @param dash_unit mm on paper of a unit of dashes @param handles the first handle that no entry has
void append_dxf_header(DxfText& out, const DxfExtent& extent, const DxfOptions& options, double dash_unit,
                       std::uint64_t handles);
/// Tables and, in release 2000, blocks. @param dash_unit mm on paper of a unit of dashes @return the handle of the model's block, which owns the entities
std::uint64_t append_dxf_tables(DxfText& out, std::span<const Layer> layers, double dash_unit, const DxfExtent& extent);
/// The dictionary that release 2000 wants.
void append_dxf_objects(DxfText& out);

/// Any text as a string of extended data: ASCII, other characters as \U+XXXX, at most 255 bytes.
std::string dxf_string(const std::string& text);

/// "VISIBLE_OUTLINE"
std::string dxf_layer_name(const Layer& layer);

}  // namespace hsr::internal
