#include <GL/osmesa.h>

#include <array>

#include "render/draw/gl_context.hpp"
#include "render/draw/shared_library.hpp"

namespace render {
namespace {

class OsmesaContext : public GlContext {
 public:
  OsmesaContext() {
    const std::array<int, 9> attributes{OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        3,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        3,
                                        0};
    context_ = create_(attributes.data(), nullptr);
    if (context_ == nullptr) throw std::runtime_error("has no GL 3.3 core profile");
  }
  ~OsmesaContext() override { destroy_(context_); }

  void make_current() override {
    if (make_current_(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side) != GL_TRUE) {
      throw std::runtime_error("OSMesa refuses to make its context current");
    }
  }
  [[nodiscard]] GlProcedure procedure(const char* name) const override { return procedure_(name); }
  [[nodiscard]] std::string name() const override { return "OSMesa"; }

 private:
  static constexpr int side = 16;

  SharedLibrary library_{{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libOSMesa.8.dylib"},
                         "libosmesa6"};
  decltype(&OSMesaCreateContextAttribs) create_ =
      library_.function<decltype(create_)>("OSMesaCreateContextAttribs");
  decltype(&OSMesaDestroyContext) destroy_ =
      library_.function<decltype(destroy_)>("OSMesaDestroyContext");
  decltype(&OSMesaMakeCurrent) make_current_ =
      library_.function<decltype(make_current_)>("OSMesaMakeCurrent");
  decltype(&OSMesaGetProcAddress) procedure_ =
      library_.function<decltype(procedure_)>("OSMesaGetProcAddress");
  // OSMesa asks for a picture to draw to, even where a framebuffer object takes its place.
  std::array<unsigned char, std::size_t{4} * side * side> unused_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> open_osmesa() { return std::make_unique<OsmesaContext>(); }

}  // namespace render
