#pragma once

namespace hsr::bench {

/// The most memory this process has held since the last `reset_peak_memory`, in bytes; since its start where the system cannot
/// reset that. Zero where it is not known.
double peak_memory();
void reset_peak_memory();

}  // namespace hsr::bench
