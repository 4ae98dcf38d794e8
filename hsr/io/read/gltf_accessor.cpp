#include "hsr/io/read/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace hsr::internal::read {

namespace {

std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

template <class T>
T load(const unsigned char* p) {
  T value;
  std::memcpy(&value, p, sizeof(T));
  if constexpr (std::endian::native == std::endian::big && sizeof(T) > 1) {
    std::array<unsigned char, sizeof(T)> raw;
    std::reverse_copy(p, p + sizeof(T), raw.begin());
    std::memcpy(&value, raw.data(), sizeof(T));
  }
  return value;
}

constexpr std::array<int, 4> types = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4};
constexpr std::array<const char*, 4> type_names = {"SCALAR", "VEC2", "VEC3", "VEC4"};

}  // namespace

GltfAccessor::GltfAccessor(const Source& source, const tinygltf::Model& model, int accessor, int components,
                           const std::string& what)
    : source_(source), model_(model), what_(what), name_("accessor " + std::to_string(accessor)) {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size())
    refuse(name_, "one of " + std::to_string(model.accessors.size()));
  const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
  check_type(a, components);
  type_ = a.componentType;
  normalised_ = a.normalized;
  count_ = a.count;
  const std::size_t element = component_size(type_) * static_cast<std::size_t>(components);
  if (a.bufferView < 0 && !a.sparse.isSparse) refuse(name_ + " without data", "a bufferView (is the geometry compressed?)");
  if (a.bufferView >= 0) {
    const Elements given = elements(a.bufferView, a.byteOffset, element, count_, name_);
    data_ = given.data;
    stride_ = given.stride;
  }
  if (a.sparse.isSparse) replace_sparse(a, element);
}

void GltfAccessor::refuse(const std::string& found, const std::string& expected) const {
  source_.refuse(what_, "found " + found + ", expected " + expected);
}

void GltfAccessor::check_type(const tinygltf::Accessor& a, int components) const {
  const int type = a.componentType;
  const bool fits =
      components == 1 ? is_index_type(type) : component_size(type) != 0 && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!fits)
    refuse(name_ + " of component type " + std::to_string(type),
           components == 1 ? "an unsigned byte, short or int" : "a float, byte or short");
  const auto k = static_cast<std::size_t>(components - 1);
  if (a.type != types[k]) refuse(name_ + " of another type", type_names[k]);
}

GltfAccessor::Elements GltfAccessor::elements(int view_number, std::size_t offset, std::size_t size, std::size_t count,
                                              const std::string& name) const {
  const std::string view_name = "bufferView " + std::to_string(view_number);
  if (view_number < 0 || static_cast<std::size_t>(view_number) >= model_.bufferViews.size())
    refuse(name + " in " + view_name, "one of " + std::to_string(model_.bufferViews.size()));
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_number)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
    refuse(view_name + " of buffer " + std::to_string(view.buffer),
           "one of " + std::to_string(model_.buffers.size()) + " buffers");
  const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
  const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
  if (stride < size) refuse("a byteStride of " + std::to_string(stride), std::to_string(size) + " or more");
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    refuse(view_name + " beyond its buffer of " + std::to_string(data.size()) + " bytes", "one inside it");
  const std::size_t room = view.byteLength;
  if (offset > room || (count != 0 && (room - offset < size || (room - offset - size) / stride < count - 1)))
    refuse(name + " of " + std::to_string(count) + " elements",
           "no more than fit into the " + std::to_string(room) + " bytes of its bufferView");
  return {data.data() + view.byteOffset + offset, stride};
}

/// The elements that the sparse part names are replaced; all others are as given, or 0.
void GltfAccessor::replace_sparse(const tinygltf::Accessor& a, std::size_t element) {
  const auto& sparse = a.sparse;
  const std::string name = "the sparse part of " + name_;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > count_)
    refuse(name + " with " + std::to_string(sparse.count) + " elements", "0 to " + std::to_string(count_));
  if (!is_index_type(sparse.indices.componentType))
    refuse(name + " with indices of component type " + std::to_string(sparse.indices.componentType),
           "an unsigned byte, short or int");
  if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) refuse(name + " with a negative byteOffset", "0 or more");
  const auto n = static_cast<std::size_t>(sparse.count);
  const Elements indices = elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                                    component_size(sparse.indices.componentType), n, name);
  const Elements values =
      elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), element, n, name);
  // Nothing in the file bounds the number of elements that are 0.
  if (data_ == nullptr && count_ > (std::size_t{1} << 28))
    refuse(name_ + " of " + std::to_string(count_) + " elements without data", "no more than " + std::to_string(1 << 28));
  replaced_.resize(count_ * element);
  if (data_ != nullptr)
    for (std::size_t i = 0; i < count_; ++i) std::memcpy(&replaced_[i * element], data_ + i * stride_, element);
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t i = index_at(indices.data + k * indices.stride, sparse.indices.componentType);
    if (i >= count_) refuse(name + " with index " + std::to_string(i), "less than " + std::to_string(count_));
    std::memcpy(&replaced_[i * element], values.data + k * values.stride, element);
  }
  data_ = replaced_.data();
  stride_ = element;
}

std::uint32_t GltfAccessor::index_at(const unsigned char* p, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *p;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(p);
    default:
      return load<std::uint32_t>(p);
  }
}

double GltfAccessor::number(std::size_t i, int c) const {
  const unsigned char* const p = data_ + i * stride_ + static_cast<std::size_t>(c) * component_size(type_);
  switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double x = load<std::int8_t>(p);
      return normalised_ ? std::max(x / 127, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalised_ ? *p / 255.0 : *p;
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double x = load<std::int16_t>(p);
      return normalised_ ? std::max(x / 32767, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const double x = load<std::uint16_t>(p);
      return normalised_ ? x / 65535 : x;
    }
    default:
      return load<float>(p);
  }
}

int components_of(const tinygltf::Model& model, int accessor) {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size()) return 0;
  const auto at = std::find(types.begin(), types.end(), model.accessors[static_cast<std::size_t>(accessor)].type);
  return at == types.end() ? 0 : static_cast<int>(at - types.begin()) + 1;
}

}  // namespace hsr::internal::read
