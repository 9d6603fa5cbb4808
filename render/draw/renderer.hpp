#pragma once

#include <memory>
#include <string>

#include "render/draw/camera.hpp"
#include "render/files/image.hpp"
#include "render/scene.hpp"

namespace render {

enum class Quality {
  draft,   ///< one sample a pixel
  film,    ///< 2 x 2 samples a pixel
  report,  ///< 64 jittered passes: soft shadows by sampled light, averaged in linear light
};

struct PictureOptions {
  int width = 1280;
  int height = 720;
  Quality quality = Quality::film;
  bool white = false;  ///< a pure white page for print instead of pale grey
};

/// The times of the parts of the last picture [s].
struct Timing {
  double draw = 0.0;       ///< until GL has finished
  double read_back = 0.0;  ///< from GL's memory, with the mean over each pixel's samples
  double labels = 0.0;
};

/// Draws scenes off-screen with llvmpipe through OSMesa, or through surfaceless EGL if there is no
/// OSMesa. The environment variable TUMBLE_GL (osmesa, egl) overrides the choice.
/// The same scene gives the same pixels on one machine, for any number of threads.
class Renderer {
 public:
  /// Throws std::runtime_error that names the missing packages if no off-screen GL opens.
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws a picture. Throws std::invalid_argument if a side is outside [1, 8192] or a value is not
  /// finite, and names it.
  Image picture(const Scene& scene, const Camera& camera, const PictureOptions& options);

  /// Returns backend, GL and driver, as in "OSMesa, 4.5 (Core Profile) Mesa 22.3.6, llvmpipe".
  [[nodiscard]] std::string device() const;

  [[nodiscard]] Timing last_timing() const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace render
