#pragma once

namespace hsr::internal {

/// What a method is made with that nobody watches: `Watch::is_watched` is asked where the code is made, and costs nothing when it runs.
struct Unwatched {
  static constexpr bool is_watched = false;
};

/// The same method, made to tell its steps.
template <class Observer>
struct Watched {
  static constexpr bool is_watched = true;
  Observer* observer;
};

}  // namespace hsr::internal
