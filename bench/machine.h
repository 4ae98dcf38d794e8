#pragma once

#include <string>

namespace hsr::bench {

/// What a table of times needs beside it: the processor, the memory, the compiler, today's date, and how busy the machine is.
std::string machine();

}  // namespace hsr::bench
