#pragma once

#include <iosfwd>
#include <string>

#include "common/triangle_mesh.hpp"

namespace common {

/// The triangles of a Wavefront OBJ file: its lines "v x y z" and "f i j k", where an index may
/// carry texture and normal as in "f 1/2/3 …" and may count back from the last vertex, as −1. What
/// else is in the file is passed over.
///
/// Throws std::runtime_error where the file cannot be read, has no triangle, or a line of those two
/// kinds is broken: a coordinate that is not a finite number, a face that is not a triangle, an
/// index of no vertex. The text is one line and names the file, and the line as in "a.obj:12: …".
TriangleMesh read_obj(const std::string& path);

/// The same of a stream.
/// name  stands for the file in messages
TriangleMesh read_obj(std::istream& stream, const std::string& name);

}  // namespace common
