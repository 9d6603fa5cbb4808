#include "render/draw/geometry.hpp"

#include <algorithm>
#include <array>

namespace render {
namespace {

Triangles shape_of(const ShapeKey& key) {
  const int segments = segments_of_level[static_cast<std::size_t>(key.level)];
  switch (key.form) {
    case Form::box:
      return box_shape();
    case Form::round:
      return round_shape(segments);
    case Form::cylinder:
      return cylinder_shape(segments);
    case Form::cone:
      break;
  }
  return cone_shape(segments);
}

void append(Triangles& target, const Triangles& source) {
  const auto first = static_cast<std::uint32_t>(target.vertices.size());
  target.vertices.insert(target.vertices.end(), source.vertices.begin(), source.vertices.end());
  for (const std::uint32_t index : source.indices) target.indices.push_back(first + index);
}

ShapeKey coarser(ShapeKey key) {
  key.level = std::max(0, key.level - 2);
  return key;
}

}  // namespace

Geometry::Geometry(const Gl& gl)
    : gl_(&gl),
      shape_vertices_(gl, GL_ARRAY_BUFFER),
      shape_indices_(gl, GL_ELEMENT_ARRAY_BUFFER),
      sheet_vertices_(gl, GL_ARRAY_BUFFER),
      sheet_indices_(gl, GL_ELEMENT_ARRAY_BUFFER),
      instances_buffer_(gl, GL_ARRAY_BUFFER) {
  gl.GenVertexArrays(1, &shape_array_);
  gl.GenVertexArrays(1, &sheet_array_);
  bind_shape_vertices(shape_array_, shape_vertices_, shape_indices_);
  load_shapes();
  bind_shape_vertices(sheet_array_, sheet_vertices_, sheet_indices_);
}

void Geometry::load_shapes() {
  Triangles all;
  const int levels = static_cast<int>(segments_of_level.size());
  for (const Form form : {Form::box, Form::round, Form::cylinder, Form::cone}) {
    for (int level = 0; level < (form == Form::box ? 1 : levels); ++level) {
      const std::size_t first = all.indices.size();
      append(all, shape_of({form, level}));
      shapes_[{form, level}] = {first, static_cast<int>(all.indices.size() - first)};
    }
  }
  shape_vertices_.fill(all.vertices);
  shape_indices_.fill(all.indices);
}

void Geometry::bind_shape_vertices(GLuint vertex_array, const Buffer& vertices,
                                   const Buffer& indices) const {
  gl_->BindVertexArray(vertex_array);
  vertices.bind();
  indices.bind();
  constexpr GLsizei stride = sizeof(Vertex);
  for (GLuint i = 0; i < 2; ++i) {
    gl_->EnableVertexAttribArray(i);
    gl_->VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, stride, byte_offset(i * sizeof(float) * 4));
  }
  for (GLuint i = 2; i < 7; ++i) {
    gl_->EnableVertexAttribArray(i);
    gl_->VertexAttribDivisor(i, 1);
  }
}

std::vector<Geometry::Copies> Geometry::copies_of(const Batches& batches) {
  std::vector<Copies> all;
  for (const auto& [key, instances] : batches) {
    all.push_back({shapes_.at(key), shapes_.at(coarser(key)), instances_.size(),
                   static_cast<int>(instances.size())});
    instances_.insert(instances_.end(), instances.begin(), instances.end());
  }
  return all;
}

void Geometry::load_sheets(const std::vector<Sheet>& sheets) {
  Triangles all;
  sheets_.clear();
  for (const Sheet& sheet : sheets) {
    const Range range{all.indices.size(), static_cast<int>(sheet.triangles.indices.size())};
    append(all, sheet.triangles);
    sheets_.push_back({range, range, instances_.size(), 1});
    instances_.push_back(sheet.paint);
  }
  if (sheets.empty()) return;
  gl_->BindVertexArray(sheet_array_);
  sheet_vertices_.fill(all.vertices);
  sheet_indices_.fill(all.indices);
}

void Geometry::load(const DrawList& list) {
  instances_.clear();
  solids_ = copies_of(list.solids);
  arrows_ = copies_of(list.arrows);
  load_sheets(list.sheets);
  instances_buffer_.fill(instances_);
}

void Geometry::draw(const Range& range, std::size_t first_instance, int instances) const {
  instances_buffer_.bind();
  for (GLuint i = 0; i < 5; ++i) {
    const std::size_t offset = first_instance * sizeof(Instance) + i * sizeof(Eigen::Vector4f);
    gl_->VertexAttribPointer(i + 2, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), byte_offset(offset));
  }
  gl_->DrawElementsInstanced(GL_TRIANGLES, range.indices, GL_UNSIGNED_INT,
                             byte_offset(range.first_index * sizeof(std::uint32_t)), instances);
}

void Geometry::draw_solids() const {
  gl_->BindVertexArray(shape_array_);
  for (const Copies& copies : solids_) {
    draw(copies.range, copies.first_instance, copies.instances);
  }
  gl_->BindVertexArray(sheet_array_);
  for (const Copies& sheet : sheets_) draw(sheet.range, sheet.first_instance, sheet.instances);
}

void Geometry::draw_arrows() const {
  gl_->BindVertexArray(shape_array_);
  for (const Copies& copies : arrows_) {
    draw(copies.range, copies.first_instance, copies.instances);
  }
}

void Geometry::draw_casters() const {
  gl_->BindVertexArray(shape_array_);
  for (const Copies& copies : solids_) {
    draw(copies.coarse_range, copies.first_instance, copies.instances);
  }
  // An open mesh must cast its shadow whichever way it faces.
  gl_->Disable(GL_CULL_FACE);
  gl_->BindVertexArray(sheet_array_);
  for (const Copies& sheet : sheets_) draw(sheet.range, sheet.first_instance, sheet.instances);
  gl_->Enable(GL_CULL_FACE);
}

}  // namespace render
