#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <vector>

#include "render/draw/gl.hpp"

namespace render {

/// Wrappers of GL objects. None deletes its own: a context frees all that is in it.

/// An offset into a buffer, which GL takes in the place of an address.
inline const void* byte_offset(std::size_t bytes) {
  return std::bit_cast<const void*>(static_cast<std::uintptr_t>(bytes));
}

/// Shaders linked into a program.
class Program {
 public:
  /// Throws std::runtime_error with the compiler's message.
  Program(const Gl& gl, const std::string& vertex_source, const std::string& fragment_source);

  void use() const;

  /// Set a uniform; the program must be in use.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const Eigen::Vector2f& value) const;
  void set(const char* name, const Eigen::Vector3f& value) const;
  void set(const char* name, const Eigen::Vector4f& value) const;
  void set(const char* name, const Eigen::Matrix3f& value) const;
  void set(const char* name, const Eigen::Matrix4f& value) const;
  void set(const char* name, const Eigen::Matrix2f& value) const;

 private:
  [[nodiscard]] GLint location(const char* name) const;

  const Gl* gl_;
  GLuint id_;
};

/// A buffer of vertices, instances or indices.
class Buffer {
 public:
  /// target  GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER
  Buffer(const Gl& gl, GLenum target);

  void bind() const;

  /// Binds the buffer and replaces what it holds.
  template <typename Element>
  void fill(const std::vector<Element>& elements) const {
    fill(elements.data(), elements.size() * sizeof(Element));
  }

 private:
  void fill(const void* data, std::size_t bytes) const;

  const Gl* gl_;
  GLenum target_;
  GLuint id_ = 0;
};

/// An sRGB picture with depth to draw to.
class Canvas {
 public:
  explicit Canvas(const Gl& gl);

  /// Directs drawing here, at that size [pixels].
  void bind(int width, int height);

  /// Rows [first, last) as RGBA, bottom row first.
  void read_rows(int first, int last, std::uint8_t* rgba) const;

 private:
  const Gl* gl_;
  GLuint framebuffer_ = 0;
  GLuint colour_ = 0;
  GLuint depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

/// A square of depths as a light sees them, to be looked up with comparison.
class DepthMap {
 public:
  DepthMap(const Gl& gl, int side);

  /// Directs drawing here and clears it.
  void bind() const;
  void bind_as_texture(int unit) const;
  [[nodiscard]] int side() const { return side_; }

 private:
  const Gl* gl_;
  int side_;
  GLuint framebuffer_ = 0;
  GLuint texture_ = 0;
};

}  // namespace render
