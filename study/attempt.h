#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "geometry/error.h"

namespace hsr::internal {

/// How a piece of work ended that may be refused, or may contradict itself where plain doubles decide.
enum class Ending : std::uint8_t { done, refused, broke_down };

struct Attempt {
  Ending ending = Ending::done;
  std::string why;  ///< "refused: ...", "broke down: ..."; done: empty
};

template <class Work>
Attempt attempt(const Work& work) {
  try {
    work();
    return {};
  } catch (const InputError& e) {
    return {Ending::refused, std::string("refused: ") + e.what()};
  } catch (const std::logic_error& e) {  // InvariantError, or the precondition of a step within the work
    return {Ending::broke_down, std::string("broke down: ") + e.what()};
  }
}

}  // namespace hsr::internal
