#pragma once

// The header declares functions only on request; here just their types are used, never the symbols,
// so nothing links against a GL library.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "render/draw/gl_context.hpp"

namespace render {

// clang-format off
#define RENDER_GL_FUNCTIONS(X)                                                                     \
  X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindFramebuffer) X(BindRenderbuffer)            \
  X(BindTexture) X(BindVertexArray) X(BlendFunc) X(BufferData) X(CheckFramebufferStatus) X(Clear)  \
  X(ClearColor) X(ColorMask) X(CompileShader) X(CreateProgram) X(CreateShader) X(CullFace)         \
  X(DepthFunc) X(DepthMask) X(Disable) X(DrawArrays) X(DrawBuffer) X(DrawElementsInstanced)        \
  X(Enable) X(EnableVertexAttribArray) X(Finish) X(FramebufferRenderbuffer)                        \
  X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) X(GenRenderbuffers) X(GenTextures)      \
  X(GenVertexArrays) X(GetError) X(GetProgramInfoLog) X(GetProgramiv) X(GetShaderInfoLog)          \
  X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(PixelStorei)                  \
  X(PolygonOffset) X(ReadBuffer) X(ReadPixels) X(RenderbufferStorage) X(ShaderSource)              \
  X(TexImage2D) X(TexParameteri) X(Uniform1f) X(Uniform1i) X(Uniform2f) X(UniformMatrix2fv)              \
  X(Uniform3f) X(Uniform4f) X(UniformMatrix3fv) X(UniformMatrix4fv) X(UseProgram)                  \
  X(VertexAttribDivisor) X(VertexAttribPointer) X(Viewport)
// clang-format on

/// The GL functions in use, as one context gives them.
struct Gl {
// gcc warns of the parentheses that clang-tidy wants around a declared name.
// NOLINTNEXTLINE(bugprone-macro-parentheses)
#define RENDER_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  RENDER_GL_FUNCTIONS(RENDER_GL_MEMBER)
#undef RENDER_GL_MEMBER
};

/// Fills the table; throws std::runtime_error that names a function which is missing.
inline Gl gl_functions(const std::function<GlProcedure(const char*)>& procedure) {
  Gl gl;
  const auto load = [&](auto& function, const char* name) {
    const GlProcedure found = procedure(name);
    if (found == nullptr) throw std::runtime_error(std::string("GL lacks ") + name);
    function = reinterpret_cast<std::decay_t<decltype(function)>>(found);
  };
#define RENDER_GL_LOAD(name) load(gl.name, "gl" #name);
  RENDER_GL_FUNCTIONS(RENDER_GL_LOAD)
#undef RENDER_GL_LOAD
  return gl;
}

}  // namespace render
