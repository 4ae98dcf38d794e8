#pragma once

#include <oneapi/tbb/collaborative_call_once.h>

#include <atomic>
#include <optional>
#include <stop_token>

#include "geometry/cancel.h"

namespace hsr::internal {

/// A value that is made when it is first asked for, once; threads that ask meanwhile help to make it.
template <class T>
class MadeOnce {
 public:
  /// @throws CancelledError if it has not been made and a stop is asked for, and what `make` throws: then the next to ask makes it
  template <class Make>
  const T& get(const std::stop_token& stop, const Make& make) const {
    if (!is_made()) throw_if_stopped(stop);
    return get(make);
  }
  template <class Make>
  const T& get(const Make& make) const {
    tbb::collaborative_call_once(flag_, [&] {
      value_.emplace(make());
      is_made_.store(true, std::memory_order_release);
    });
    return *value_;
  }
  /// Whether it is there already; for choices of speed only.
  bool is_made() const { return is_made_.load(std::memory_order_acquire); }

 private:
  mutable tbb::collaborative_once_flag flag_;
  mutable std::optional<T> value_;
  mutable std::atomic<bool> is_made_ = false;
};

}  // namespace hsr::internal
