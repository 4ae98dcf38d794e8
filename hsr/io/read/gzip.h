#pragma once

#include <cstddef>
#include <string_view>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

bool is_gzip(std::string_view bytes);

/// Above this a gzip file is refused: it would not be a model that fits into memory, but it may be a bomb.
inline constexpr std::size_t most_inflated = std::size_t{1} << 32;

/// All members of a gzip file, inflated; zeros behind the last one are passed over. Memory grows with what really came out.
/// @throws InputError if the data is damaged, truncated, or inflates to more than `most` bytes
Bytes gunzip(const Source& source, std::size_t most = most_inflated);

}  // namespace hsr::internal::read
