#pragma once

#include <Model/COM/NMR_DLLInterfaces.h>

#include <utility>

namespace hsr::internal {

/// Something of lib3mf's, that is given back at the end.
class Lib3mfHandle {
 public:
  Lib3mfHandle() = default;
  Lib3mfHandle(const Lib3mfHandle&) = delete;
  Lib3mfHandle& operator=(const Lib3mfHandle&) = delete;
  Lib3mfHandle(Lib3mfHandle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Lib3mfHandle& operator=(Lib3mfHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Lib3mfHandle() {
    if (handle_ != nullptr) NMR::lib3mf_release(handle_);
  }

  NMR::PLib3MFBase* get() const { return handle_; }
  /// Where one of lib3mf's functions puts it.
  NMR::PLib3MFBase** place() { return &handle_; }

 private:
  NMR::PLib3MFBase* handle_ = nullptr;
};

}  // namespace hsr::internal
