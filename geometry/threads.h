#pragma once

#include <cstddef>
#include <memory>

namespace hsr {

/// While it lives, hsr computes with at most so many threads, the caller's included, in the whole program; of several such
/// objects the smallest number holds. Results do not depend on it. Without one: as many threads as the machine has.
///
/// Threads are those of oneTBB, which the program may use for work of its own: for that the limit holds, too. Where another part
/// of the program has a tbb::task_arena, a call from within it stays within that arena.
class Threads {
 public:
  /// @throws PreconditionError if `most` is 0
  explicit Threads(std::size_t most);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  struct Limit;
  std::unique_ptr<Limit> limit_;
};

}  // namespace hsr
