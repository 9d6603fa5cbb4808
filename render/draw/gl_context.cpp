#include "render/draw/gl_context.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace render {
namespace {

struct Backend {
  std::string_view name;
  std::unique_ptr<GlContext> (*open)();
};

// In the order in which they are tried.
std::vector<Backend> built_backends() {
  return {
#ifdef RENDER_OSMESA
      {"osmesa", open_osmesa},
#endif
#ifdef RENDER_EGL
      {"egl", open_egl},
#endif
  };
}

}  // namespace

std::unique_ptr<GlContext> open_gl_context() {
  const char* const variable = std::getenv("TUMBLE_GL");
  const std::string chosen = variable == nullptr ? "" : variable;
  std::string names;
  std::string reasons;
  for (const Backend& backend : built_backends()) {
    names.append(" ").append(backend.name);
    if (!chosen.empty() && chosen != backend.name) continue;
    try {
      return backend.open();
    } catch (const std::runtime_error& error) {
      reasons.append("; ").append(backend.name).append(" ").append(error.what());
    }
  }
  // Each backend that was tried left its reason.
  if (reasons.empty()) {
    throw std::runtime_error("TUMBLE_GL=" + chosen + " is not one of:" + names);
  }
  throw std::runtime_error(
      "no off-screen GL: install libosmesa6, or libegl1 libegl-mesa0 libgl1-mesa-dri" + reasons);
}

}  // namespace render
