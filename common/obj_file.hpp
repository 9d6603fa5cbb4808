#pragma once

#include <iosfwd>
#include <string>

#include "common/triangle_mesh.hpp"

namespace common {

/// The triangles of a Wavefront OBJ file: its lines "v x y z" and "f i j k …".
///
/// A coordinate is the nearest double; what follows z (a weight, a colour) must be numbers and is
/// passed over. An index counts from 1, or back from the last vertex so far as −1, and may carry
/// texture and normal, as in 1/2/3, 1//3 or 1/2/; these are passed over. A face of more than three
/// corners is cut into triangles, its own corners kept: see triangulated. "#" begins a comment
/// anywhere, "\" at a line's end goes on in the next; lines end in LF or CRLF, and a byte-order
/// mark is no part of the first. Lines of other kinds are passed over.
///
/// Throws std::runtime_error where the file cannot be read, has no face, or a line of those two
/// kinds is broken: a coordinate that is not a finite double, fewer than three corners, an index
/// of no vertex. The text is one line and names the file, and the line as in "a.obj:12: …".
TriangleMesh read_obj(const std::string& path);

/// The same of a stream.
/// name  stands for the file in messages
TriangleMesh read_obj(std::istream& stream, const std::string& name);

}  // namespace common
