#include "hsr/step/fault_guard.h"

#include <array>
#include <csetjmp>
#include <csignal>
#include <mutex>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

constexpr std::array<int, 4> faults = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};

thread_local sigjmp_buf* way_back = nullptr;
std::array<struct sigaction, faults.size()> before;

/// Outside of a guarded call the fault is as it was without us: the instruction is tried again under the action that was there.
extern "C" void on_fault(int signal) {
  if (way_back != nullptr) siglongjmp(*way_back, signal);
  for (std::size_t k = 0; k < faults.size(); ++k)
    if (faults[k] == signal) sigaction(signal, &before[k], nullptr);
}

/// The handler is there while some thread is in a guarded call; else faults are our host's.
class Handler {
 public:
  Handler() {
    const std::scoped_lock lock(mutex_);
    if (users_++ > 0) return;
    struct sigaction action = {};
    action.sa_handler = on_fault;
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    for (std::size_t k = 0; k < faults.size(); ++k) sigaction(faults[k], &action, &before[k]);
  }
  Handler(const Handler&) = delete;
  Handler& operator=(const Handler&) = delete;
  ~Handler() {
    const std::scoped_lock lock(mutex_);
    if (--users_ > 0) return;
    for (std::size_t k = 0; k < faults.size(); ++k) sigaction(faults[k], &before[k], nullptr);
  }

 private:
  inline static std::mutex mutex_;
  inline static int users_ = 0;
};

/// Where the handler runs where the stack has come to its end, as it does in entities that are nested without end.
class OtherStack {
 public:
  OtherStack() {
    stack_t other = {};
    other.ss_sp = bytes_.data();
    other.ss_size = bytes_.size();
    sigaltstack(&other, &before_);
  }
  OtherStack(const OtherStack&) = delete;
  OtherStack& operator=(const OtherStack&) = delete;
  ~OtherStack() { sigaltstack(&before_, nullptr); }

 private:
  std::array<char, std::size_t{1} << 16U> bytes_;
  stack_t before_ = {};
};

}  // namespace

void survive_faults(const std::string& path, const std::function<void()>& function) {
  const Handler handler;
  const OtherStack other_stack;
  sigjmp_buf here;
  sigjmp_buf* const outer = way_back;
  if (const int fault = sigsetjmp(here, 1); fault != 0) {
    way_back = outer;
    throw InputError(path + ": found something on which Open CASCADE fails (signal " + std::to_string(fault) +
                     "), expected a file without missing or broken entities");
  }
  way_back = &here;
  try {
    function();
  } catch (...) {
    way_back = outer;
    throw;
  }
  way_back = outer;
}

}  // namespace hsr::internal
