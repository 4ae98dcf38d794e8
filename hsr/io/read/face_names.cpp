#include "hsr/io/read/face_names.h"

namespace hsr::internal::read {

void FaceNames::label(std::size_t faces) {
  if (of_face_.size() + 1 < faces) of_face_.resize(faces - 1, fallback_.empty() ? none : number_of(fallback_));
  if (number_ == none) {
    if (name_)
      number_ = number_of(is_new_ ? unused(*name_) : *name_);
    else if (!fallback_.empty())
      number_ = number_of(fallback_);
  }
  of_face_.push_back(number_);
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
