#include "geometry/threads.h"

#include <tbb/global_control.h>

#include "geometry/error.h"

namespace hsr {

struct Threads::Limit {
  tbb::global_control control;
};

Threads::Threads(std::size_t most) {
  require(most > 0, "Threads: found 0, expected at least one thread");
  limit_.reset(new Limit{tbb::global_control(tbb::global_control::max_allowed_parallelism, most)});
}

Threads::~Threads() = default;

}  // namespace hsr
