// Loaded before a program (LD_PRELOAD), lets one call to the system fail: HSR_FAULT="write 3" the third one to write. Calls count from
// where main() asks whether standard error is a terminal. HSR_FAULT_COUNT names a file for how many there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

std::atomic<long> calls = 0;
long failing = 0;
char kind[32] = "";
bool counts = false;

bool fails(const char* call, int error) {
  if (!counts || std::strcmp(call, kind) != 0 || ++calls != failing) return false;
  errno = error;
  return true;
}

template <class Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void begin() {
  static bool has_begun = false;
  if (has_begun) return;
  has_begun = true;
  const char* const text = std::getenv("HSR_FAULT");
  counts = text != nullptr && std::sscanf(text, "%31s %ld", kind, &failing) == 2;
}

struct Report {
  ~Report() {
    const char* const path = std::getenv("HSR_FAULT_COUNT");
    if (!counts || path == nullptr) return;
    counts = false;
    if (std::FILE* const file = std::fopen(path, "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
} report;

}  // namespace

extern "C" {

int isatty(int file) noexcept {
  static const auto call = real(&isatty, "isatty");
  begin();
  return call(file);
}

void* malloc(size_t size) noexcept { return fails("memory", ENOMEM) ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) noexcept { return fails("memory", ENOMEM) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* p, size_t size) noexcept { return fails("memory", ENOMEM) ? nullptr : __libc_realloc(p, size); }
void* aligned_alloc(size_t alignment, size_t size) noexcept {
  return fails("memory", ENOMEM) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** p, size_t alignment, size_t size) noexcept {
  if (fails("memory", ENOMEM)) return ENOMEM;
  *p = __libc_memalign(alignment, size);
  return *p == nullptr ? ENOMEM : 0;
}

ssize_t write(int file, const void* bytes, size_t size) {
  static const auto call = real(&write, "write");
  return fails("write", ENOSPC) ? -1 : call(file, bytes, size);
}
ssize_t read(int file, void* bytes, size_t size) {
  static const auto call = real(&read, "read");
  return fails("read", EIO) ? -1 : call(file, bytes, size);
}
int close(int file) {
  static const auto call = real(&close, "close");
  const int result = call(file);
  return fails("close", EIO) ? -1 : result;
}
int rename(const char* from, const char* to) noexcept {
  static const auto call = real(&rename, "rename");
  return fails("rename", EACCES) ? -1 : call(from, to);
}
int open(const char* path, int flags, ...) {
  static const auto call = real(&open, "open");
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(list, mode_t) : 0;
  va_end(list);
  return fails("open", EACCES) ? -1 : call(path, flags, mode);
}

}  // extern "C"
