#include "study/opengl_buffer.h"

#define GL_GLEXT_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

namespace {

std::string reason;  // why there is no context

/// Functions of OpenGL, asked for by name: none is linked.
#define HSR_GL_FUNCTIONS(X)                                    \
  X(PFNGLGETSTRINGPROC, GetString)                             \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                         \
  X(PFNGLGETERRORPROC, GetError)                               \
  X(PFNGLCREATESHADERPROC, CreateShader)                       \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                       \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                     \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                     \
  X(PFNGLATTACHSHADERPROC, AttachShader)                       \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                         \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                       \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)           \
  X(PFNGLUNIFORM1UIPROC, Uniform1ui)                           \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                           \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                 \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                 \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)           \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)               \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)               \
  X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)         \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)         \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer) \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)   \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                 \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                 \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)           \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                           \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                           \
  X(PFNGLBUFFERDATAPROC, BufferData)                           \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                     \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)         \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) \
  X(PFNGLVIEWPORTPROC, Viewport)                               \
  X(PFNGLENABLEPROC, Enable)                                   \
  X(PFNGLDISABLEPROC, Disable)                                 \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                             \
  X(PFNGLCLIPCONTROLPROC, ClipControl)                         \
  X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                     \
  X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                     \
  X(PFNGLCLEARBUFFERUIVPROC, ClearBufferuiv)                   \
  X(PFNGLDRAWARRAYSPROC, DrawArrays)                           \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                         \
  X(PFNGLREADPIXELSPROC, ReadPixels)

struct Functions {
#define HSR_DECLARE(type, name) type name = nullptr;
  HSR_GL_FUNCTIONS(HSR_DECLARE)
#undef HSR_DECLARE

  bool load() {
    bool all = true;
#define HSR_LOAD(type, name)                                    \
  name = reinterpret_cast<type>(eglGetProcAddress("gl" #name)); \
  all = all && name != nullptr;
    HSR_GL_FUNCTIONS(HSR_LOAD)
#undef HSR_LOAD
    return all;
  }
};

/// Of each sample the number of the triangle, as it was drawn.
constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec4 place;
layout(location = 1) in float beyond_near;
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[1]; };
void main() { gl_Position = place; gl_ClipDistance[0] = beyond_near; }
)";
constexpr const char* fragment_shader = R"(#version 330 core
uniform uint first;  // each call counts from 0
out uint triangle;
void main() { triangle = first + uint(gl_PrimitiveID); }
)";

struct Corner {
  std::array<float, 4> place;
  float beyond_near;
};

}  // namespace

struct OpenGl::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  Functions gl;
  GLuint program = 0;
  GLint first = 0;  // where the uniform is
  std::string driver;
  GLint subpixel_bits = 0, largest = 0;

  ~Context() {
    if (context != EGL_NO_CONTEXT) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display, context);
    }
    // The display is that of the process: another context may be in use.
  }

  /// Nothing, or why there is none.
  std::string begin() {
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display != nullptr) display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || eglInitialize(display, &major, &minor) != EGL_TRUE) return "there is no display of EGL";
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return "EGL has no OpenGL";
    constexpr std::array<EGLint, 7> wanted = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context == EGL_NO_CONTEXT) return "there is no driver with OpenGL 4.5";
    if (!make_current() || !gl.load()) return "the driver's context cannot be used without a surface";
    driver = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    driver.resize(std::min(driver.find(" ("), driver.size()));  // "llvmpipe (LLVM 15.0.6, 256 bits)"
    gl.GetIntegerv(GL_SUBPIXEL_BITS, &subpixel_bits);
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    return compile() ? "" : "the driver does not take the shaders";
  }

  bool make_current() { return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE; }

  bool compile() {
    program = gl.CreateProgram();
    for (const auto& [kind, text] :
         {std::pair(GL_VERTEX_SHADER, vertex_shader), std::pair(GL_FRAGMENT_SHADER, fragment_shader)}) {
      const GLuint shader = gl.CreateShader(static_cast<GLenum>(kind));
      gl.ShaderSource(shader, 1, &text, nullptr);
      gl.CompileShader(shader);
      gl.AttachShader(program, shader);
    }
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    first = gl.GetUniformLocation(program, "first");
    return linked == GL_TRUE;
  }
};

std::unique_ptr<OpenGl> OpenGl::make() {
  auto context = std::make_unique<Context>();
  reason = context->begin();
  if (!reason.empty()) return nullptr;
  return std::unique_ptr<OpenGl>(new OpenGl(std::move(context)));
}

const std::string& OpenGl::why() { return reason; }
OpenGl::OpenGl(std::unique_ptr<Context> context) : context_(std::move(context)) {}
OpenGl::~OpenGl() = default;
const std::string& OpenGl::driver() const { return context_->driver; }
int OpenGl::subpixel_bits() const { return context_->subpixel_bits; }

namespace {

/// Corners of all triangles in clip coordinates, in the order in which they are drawn.
std::vector<Corner> corners_of(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                               const OpenGlOptions& options) {
  const SampleProjection<double> project(view, samples);
  const bool is_reversed = options.format == DepthFormat::reversed_float32;
  std::vector<Corner> of_vertex(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[VertexId(v)];
    const Seen<double> seen = project(p);
    const double w = view.is_perspective() ? 1 / (seen.nearness + 1) : 1;  // the depth over that of the plane of the samples
    const double x = 2 * (seen.x + 0.5) / samples.width - 1, y = 2 * (seen.y + 0.5) / samples.height - 1;
    const double depth = range.depth(seen.nearness);
    // Reversed, 1 - depth without the rounding of that difference.
    const double z = is_reversed ? (seen.nearness - range.far) / (range.near - range.far) : 2 * depth - 1;
    of_vertex[v] = {{static_cast<float>(x * w), static_cast<float>(y * w), static_cast<float>(z * w), static_cast<float>(w)},
                    view.cuts() ? static_cast<float>(beyond_near<double>(view, p)) : 1.0F};
  }
  std::vector<Corner> corners;
  corners.reserve(3 * mesh.triangles.size());
  constexpr float far = 0x1p60F;
  const auto is_drawable = [&](VertexId v) {
    const Corner& c = of_vertex[v.value];
    return std::all_of(c.place.begin(), c.place.end(), [&](float x) { return std::fabs(x) < far; });
  };
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& vertices = mesh.triangles[TriangleId(options.ties.from_top(k, mesh.triangles.size()))];
    const bool is_drawn = std::all_of(vertices.begin(), vertices.end(), is_drawable);
    // What is not drawn keeps its place in the count, as a point.
    for (const VertexId v : vertices) corners.push_back(is_drawn ? of_vertex[v.value] : Corner{{0, 0, 0, 1}, 1});
  }
  return corners;
}

GLenum storage(DepthFormat format) {
  switch (format) {
    case DepthFormat::fixed16:
      return GL_DEPTH_COMPONENT16;
    case DepthFormat::fixed24:
      return GL_DEPTH_COMPONENT24;
    case DepthFormat::float32:
    case DepthFormat::reversed_float32:
      return GL_DEPTH_COMPONENT32F;
    default:
      throw InputError("OpenGL: found the depth format " + std::string(name(format)) +
                       ", expected fixed 16, fixed 24 or a float of 32 bits");
  }
}

}  // namespace

Image<TriangleId> OpenGl::draw(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                               const OpenGlOptions& options) {
  const Functions& gl = context_->gl;
  const int width = samples.width, height = samples.height;
  if (std::max(width, height) > context_->largest)
    throw InputError("OpenGL: found " + std::to_string(std::max(width, height)) + " samples each way, expected at most " +
                     std::to_string(context_->largest));
  const GLenum depth_storage = storage(options.format);
  const std::vector<Corner> corners = corners_of(mesh, view, samples, range, options);
  if (!context_->make_current()) throw InputError("OpenGL: the context cannot be used by this thread");
  GLuint frame = 0, array = 0, buffer = 0;
  std::array<GLuint, 2> stores = {0, 0};
  gl.GenFramebuffers(1, &frame);
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
  gl.GenRenderbuffers(2, stores.data());
  for (const std::size_t k : {0U, 1U}) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, stores[k]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, k == 0 ? GL_R32UI : depth_storage, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, k == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, stores[k]);
  }
  const bool is_complete = gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)), corners.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
  gl.VertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(Corner),
                         reinterpret_cast<const void*>(offsetof(Corner, beyond_near)));
  gl.EnableVertexAttribArray(0);
  gl.EnableVertexAttribArray(1);

  const bool is_reversed = options.format == DepthFormat::reversed_float32;
  gl.UseProgram(context_->program);
  gl.Viewport(0, 0, width, height);
  gl.ClipControl(GL_LOWER_LEFT, is_reversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CLIP_DISTANCE0);
  gl.DepthFunc(is_reversed ? GL_GREATER : GL_LESS);
  constexpr GLuint nothing = 0xffffffffU;
  const GLfloat farthest = is_reversed ? 0.0F : 1.0F;
  gl.ClearBufferuiv(GL_COLOR, 0, &nothing);
  gl.ClearBufferfv(GL_DEPTH, 0, &farthest);
  const bool has_offset = options.offset_factor != 0 || options.offset_units != 0;
  const std::size_t n = mesh.triangles.size(), plain = has_offset ? std::min(options.offset_from, n) : n;
  gl.Uniform1ui(context_->first, 0);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * plain));
  std::vector<GLuint> drawn(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  if (plain < n) {
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.Uniform1ui(context_->first, static_cast<GLuint>(plain));
    gl.PolygonOffset(options.offset_factor, options.offset_units);
    gl.DrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * plain), static_cast<GLsizei>(3 * (n - plain)));
    gl.Disable(GL_POLYGON_OFFSET_FILL);
  }
  gl.ReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, drawn.data());
  const GLenum error = gl.GetError();
  gl.DeleteBuffers(1, &buffer);
  gl.DeleteVertexArrays(1, &array);
  gl.DeleteRenderbuffers(2, stores.data());
  gl.DeleteFramebuffers(1, &frame);
  if (!is_complete || error != GL_NO_ERROR)
    throw InputError("OpenGL: the driver cannot draw to " + std::string(name(options.format)));
  Image<TriangleId> image(width, height);
  for (std::size_t k = 0; k < drawn.size(); ++k)
    if (drawn[k] != nothing) image.pixels[k] = TriangleId(options.ties.from_top(drawn[k], n));
  return image;
}

}  // namespace hsr::internal
