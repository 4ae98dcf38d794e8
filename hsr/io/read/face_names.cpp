#include "hsr/io/read/face_names.h"

namespace hsr::internal::read {

void FaceNames::label(Labels& labels) {
  if (!is_used_) {
    is_used_ = true;
    const bool has_fallback = !fallback_.empty() && of_face_.before_first_name + of_wire_.before_first_name > 0;
    const std::uint32_t unnamed = has_fallback ? number_of(fallback_) : none;
    for (Labels* const before : {&of_face_, &of_wire_}) before->numbers.assign(before->before_first_name, unnamed);
  }
  if (number_ == none) {
    if (name_)
      number_ = number_of(is_new_ ? unused(*name_) : *name_);
    else if (!fallback_.empty())
      number_ = number_of(fallback_);
  }
  labels.numbers.push_back(number_);
}

std::uint32_t FaceNames::number_of(const std::string& name) {
  const auto [at, is_first] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
  if (is_first) names_.push_back(name);
  return at->second;
}

std::string FaceNames::unused(const std::string& name) {
  std::size_t& n = repeats_[name];
  std::string candidate = name;
  if (n != 0 || numbers_.count(candidate) != 0) {
    n = n == 0 ? 1 : n;
    do candidate = name + " [" + std::to_string(++n) + "]";
    while (numbers_.count(candidate) != 0);
  } else {
    n = 1;
  }
  return candidate;
}

}  // namespace hsr::internal::read
