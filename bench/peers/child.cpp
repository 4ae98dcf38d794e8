#include "bench/peers/child.h"

#include <poll.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "geometry/error.h"

namespace hsr::bench {

namespace {

void write_all(int file, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(file, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(3);
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

/// The first byte tells a result from an excuse.
[[noreturn]] void work_and_exit(const std::function<std::string()>& work, const Limits& limits, int file) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody would be left to enforce the time limit
#endif
  const auto bytes = static_cast<rlim_t>(limits.gigabytes * 1e9);
  const rlimit memory = {bytes, bytes}, core = {0, 0};
  if (bytes > 0) setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &core);
  std::string message;
  try {
    message = "+" + work();
  } catch (const std::bad_alloc&) {
    message = "-out of memory";
  } catch (const std::exception& error) {
    message = std::string("-") + error.what();
  } catch (...) {
    message = "-exception";
  }
  write_all(file, message.data(), message.size());
  _exit(0);
}

}  // namespace

Ended run_apart(const std::function<std::string()>& work, const Limits& limits) {
  using Clock = std::chrono::steady_clock;
  int ends[2];
  require(pipe(ends) == 0, "run_apart: no pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  require(child >= 0, "run_apart: no process");
  if (child == 0) {
    close(ends[0]);
    work_and_exit(work, limits, ends[1]);
  }
  close(ends[1]);
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
  std::string message;
  bool over_time = false;
  for (;;) {
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    pollfd ready = {ends[0], POLLIN, 0};
    const int events = left > 0 ? poll(&ready, 1, static_cast<int>(left * 1000) + 1) : 0;
    if (events < 0 && errno == EINTR) continue;
    if (events <= 0) {
      over_time = true;
      kill(child, SIGKILL);
      break;
    }
    char bytes[1 << 16];
    const ssize_t count = read(ends[0], bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    message.append(bytes, static_cast<std::size_t>(count));
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (over_time) return {Ended::How::over_time, {}};
  if (WIFSIGNALED(status)) return {Ended::How::failed, strsignal(WTERMSIG(status))};
  if (message.empty()) return {Ended::How::failed, "ended early"};
  return {message[0] == '+' ? Ended::How::done : Ended::How::failed, message.substr(1)};
}

}  // namespace hsr::bench
