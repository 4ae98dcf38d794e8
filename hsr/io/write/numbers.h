#pragma once

namespace hsr {

/// How numbers are written as JSON: the shortest text that reads back as the same double, or exactly as a string "p/q".
enum class Numbers { rounded, exact };

}  // namespace hsr
