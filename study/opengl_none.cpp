// Where hsr is built without OpenGL.
#include "study/opengl_buffer.h"

namespace hsr::internal {

struct OpenGl::Context {
  std::string driver;
};

std::unique_ptr<OpenGl> OpenGl::make() { return nullptr; }
const std::string& OpenGl::why() {
  static const std::string reason = "hsr is built without OpenGL (HSR_OPENGL)";
  return reason;
}
OpenGl::OpenGl(std::unique_ptr<Context> context) : context_(std::move(context)) {}
OpenGl::~OpenGl() = default;
const std::string& OpenGl::driver() const { return context_->driver; }
int OpenGl::subpixel_bits() const { return 0; }
Image<TriangleId> OpenGl::draw(const Mesh& /*mesh*/, const View& /*view*/, const SampleGrid& samples,
                               const DepthRange& /*range*/, const OpenGlOptions& /*options*/) {
  return {samples.width, samples.height};
}

}  // namespace hsr::internal
