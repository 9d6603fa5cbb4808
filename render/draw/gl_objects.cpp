#include "render/draw/gl_objects.hpp"

#include <array>

namespace render {
namespace {

GLuint compiled(const Gl& gl, GLenum kind, const std::string& source) {
  const GLuint shader = gl.CreateShader(kind);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint success = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &success);
  if (success == GL_TRUE) return shader;
  std::array<char, 2048> message{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), nullptr, message.data());
  throw std::runtime_error(std::string("shader: ") + message.data());
}

void require_complete(const Gl& gl) {
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("GL cannot draw to a picture of this size");
  }
}

}  // namespace

Program::Program(const Gl& gl, const std::string& vertex_source, const std::string& fragment_source)
    : gl_(&gl), id_(gl.CreateProgram()) {
  gl.AttachShader(id_, compiled(gl, GL_VERTEX_SHADER, vertex_source));
  gl.AttachShader(id_, compiled(gl, GL_FRAGMENT_SHADER, fragment_source));
  gl.LinkProgram(id_);
  GLint success = 0;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &success);
  if (success == GL_TRUE) return;
  std::array<char, 2048> message{};
  gl.GetProgramInfoLog(id_, static_cast<GLsizei>(message.size()), nullptr, message.data());
  throw std::runtime_error(std::string("shader program: ") + message.data());
}

void Program::use() const { gl_->UseProgram(id_); }

GLint Program::location(const char* name) const { return gl_->GetUniformLocation(id_, name); }

void Program::set(const char* name, int value) const { gl_->Uniform1i(location(name), value); }

void Program::set(const char* name, float value) const { gl_->Uniform1f(location(name), value); }

void Program::set(const char* name, const Eigen::Vector2f& value) const {
  gl_->Uniform2f(location(name), value.x(), value.y());
}

void Program::set(const char* name, const Eigen::Vector3f& value) const {
  gl_->Uniform3f(location(name), value.x(), value.y(), value.z());
}

void Program::set(const char* name, const Eigen::Vector4f& value) const {
  gl_->Uniform4f(location(name), value.x(), value.y(), value.z(), value.w());
}

void Program::set(const char* name, const Eigen::Matrix3f& value) const {
  gl_->UniformMatrix3fv(location(name), 1, GL_FALSE, value.data());
}

void Program::set(const char* name, const Eigen::Matrix4f& value) const {
  gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}

void Program::set(const char* name, const Eigen::Matrix2f& value) const {
  gl_->UniformMatrix2fv(location(name), 1, GL_FALSE, value.data());
}

Buffer::Buffer(const Gl& gl, GLenum target) : gl_(&gl), target_(target) { gl.GenBuffers(1, &id_); }

void Buffer::bind() const { gl_->BindBuffer(target_, id_); }

void Buffer::fill(const void* data, std::size_t bytes) const {
  bind();
  gl_->BufferData(target_, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

Canvas::Canvas(const Gl& gl) : gl_(&gl) {
  gl.GenFramebuffers(1, &framebuffer_);
  gl.GenRenderbuffers(1, &colour_);
  gl.GenRenderbuffers(1, &depth_);
}

void Canvas::bind(int width, int height) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->Viewport(0, 0, width, height);
  gl_->Enable(GL_FRAMEBUFFER_SRGB);
  if (width == width_ && height == height_) return;
  gl_->BindRenderbuffer(GL_RENDERBUFFER, colour_);
  gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, width, height);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_);
  gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  require_complete(*gl_);
  width_ = width;
  height_ = height;
}

void Canvas::read_rows(int first, int last, std::uint8_t* rgba) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, first, width_, last - first, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

DepthMap::DepthMap(const Gl& gl, int side) : gl_(&gl), side_(side) {
  gl.GenTextures(1, &texture_);
  gl.BindTexture(GL_TEXTURE_2D, texture_);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.GenFramebuffers(1, &framebuffer_);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  require_complete(gl);
}

void DepthMap::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->Viewport(0, 0, side_, side_);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

void DepthMap::bind_as_texture(int unit) const {
  gl_->ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  gl_->BindTexture(GL_TEXTURE_2D, texture_);
}

}  // namespace render
