#pragma once

#include <map>
#include <vector>

#include "render/draw/draw_list.hpp"
#include "render/draw/gl_objects.hpp"

namespace render {

/// The triangles of a scene in GL's memory.
class Geometry {
 public:
  explicit Geometry(const Gl& gl);

  void load(const DrawList& list);

  /// Draw with the program in use.
  void draw_solids() const;
  void draw_arrows() const;
  /// The solids again, with coarser curves, since a shadow's edge is soft.
  void draw_casters() const;

 private:
  struct Range {
    std::size_t first_index;
    int indices;
  };
  struct Copies {
    Range range;
    Range coarse_range;
    std::size_t first_instance;
    int instances;
  };

  void load_shapes();
  [[nodiscard]] std::vector<Copies> copies_of(const Batches& batches);
  void load_sheets(const std::vector<Sheet>& sheets);
  void bind_shape_vertices(GLuint vertex_array, const Buffer& vertices,
                           const Buffer& indices) const;
  void draw(const Range& range, std::size_t first_instance, int instances) const;

  const Gl* gl_;
  Buffer shape_vertices_;
  Buffer shape_indices_;
  Buffer sheet_vertices_;
  Buffer sheet_indices_;
  Buffer instances_buffer_;
  GLuint shape_array_ = 0;
  GLuint sheet_array_ = 0;
  std::map<ShapeKey, Range> shapes_;
  std::vector<Instance> instances_;
  std::vector<Copies> solids_;
  std::vector<Copies> arrows_;
  std::vector<Copies> sheets_;
};

}  // namespace render
