#pragma once

#include <cstddef>
#include <string_view>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

bool is_gzip(std::string_view bytes);

/// Above this a gzip file is refused, and no memory is asked for: it would not be a model, or not one that fits. 4 GiB, or a quarter
/// of the memory that the process may have (RLIMIT_DATA) if that is less: the text of a model is about half of what it takes.
std::size_t most_inflated();

/// All members of a gzip file, inflated; zeros behind the last one are passed over. Memory grows with what really came out.
/// @throws InputError if the data is damaged, truncated, or inflates to more than `most` bytes, or says at its end that it will
Bytes gunzip(const Source& source, std::size_t most = most_inflated());

}  // namespace hsr::internal::read
