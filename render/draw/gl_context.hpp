#pragma once

#include <memory>
#include <string>

namespace render {

using GlProcedure = void (*)();

/// A GL 3.3 core context without a window. Draw into a framebuffer object of your own: it has none.
class GlContext {
 public:
  GlContext() = default;
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Directs the calling thread's GL calls here. Throws std::runtime_error where it fails.
  virtual void make_current() = 0;
  [[nodiscard]] virtual GlProcedure procedure(const char* name) const = 0;
  [[nodiscard]] virtual std::string name() const = 0;
};

/// Open a context; each throws std::runtime_error that says which package is missing.
std::unique_ptr<GlContext> open_osmesa();
std::unique_ptr<GlContext> open_egl();

/// Opens OSMesa, which always draws in software and so gives the same pixels everywhere, else
/// surfaceless EGL. TUMBLE_GL=osmesa or egl allows that one alone.
/// Throws std::runtime_error that tells why nothing opened and which packages help.
std::unique_ptr<GlContext> open_gl_context();

}  // namespace render
