#include "geometry/number_memory.h"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace hsr::internal {

namespace {

void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* reallocate(void* memory, std::size_t, std::size_t size) {
  void* const larger = std::realloc(memory, size);
  if (larger == nullptr) throw std::bad_alloc();
  return larger;
}

void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void throw_where_numbers_have_no_memory() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace hsr::internal
