#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>

#include "render/draw/gl_context.hpp"
#include "render/draw/shared_library.hpp"

namespace render {
namespace {

class EglContext : public GlContext {
 public:
  EglContext() {
    // On a machine with a graphics card EGL would draw there, with other pixels.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(procedure_("eglGetPlatformDisplayEXT"));
    if (platform_display == nullptr) throw std::runtime_error("has no platform displays");
    display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || initialize_(display_, nullptr, nullptr) != EGL_TRUE) {
      throw std::runtime_error("opens no surfaceless display (libegl-mesa0, libgl1-mesa-dri?)");
    }
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    if (bind_api_(EGL_OPENGL_API) == EGL_TRUE) {
      context_ = create_(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    }
    if (context_ == EGL_NO_CONTEXT) {
      terminate_(display_);
      throw std::runtime_error("has no GL 3.3 core profile");
    }
  }
  ~EglContext() override {
    make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    destroy_(display_, context_);
    // The display is the process's, shared with other contexts, so it is not terminated.
  }

  void make_current() override {
    if (make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      throw std::runtime_error("EGL refuses to make its context current");
    }
  }
  [[nodiscard]] GlProcedure procedure(const char* name) const override { return procedure_(name); }
  [[nodiscard]] std::string name() const override { return "EGL"; }

 private:
  SharedLibrary library_{{"libEGL.so.1", "libEGL.so"}, "libegl1, libegl-mesa0, libgl1-mesa-dri"};
  decltype(&eglGetProcAddress) procedure_ =
      library_.function<decltype(procedure_)>("eglGetProcAddress");
  decltype(&eglInitialize) initialize_ = library_.function<decltype(initialize_)>("eglInitialize");
  decltype(&eglTerminate) terminate_ = library_.function<decltype(terminate_)>("eglTerminate");
  decltype(&eglBindAPI) bind_api_ = library_.function<decltype(bind_api_)>("eglBindAPI");
  decltype(&eglCreateContext) create_ = library_.function<decltype(create_)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_ =
      library_.function<decltype(destroy_)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current_ =
      library_.function<decltype(make_current_)>("eglMakeCurrent");
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> open_egl() { return std::make_unique<EglContext>(); }

}  // namespace render
