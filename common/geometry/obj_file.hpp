#pragma once

#include <iosfwd>
#include <string>

#include "common/geometry/triangle_mesh.hpp"

namespace common {

/// Reads the triangles of a Wavefront OBJ file from its lines "v x y z" and "f i j k …".
///
/// A coordinate becomes the nearest double. Anything after z (a weight, a colour) must be numbers
/// and is ignored. An index counts from 1, or back from the last vertex so far as −1. It may carry
/// texture and normal, as in 1/2/3, 1//3 or 1/2/, and these are ignored. A face of more than three
/// corners is cut into triangles with its own corners only: see triangulated. "#" begins a comment
/// anywhere. "\" at a line's end continues the line. Lines end in LF or CRLF, and a byte-order mark
/// is not part of the first line. Lines of other kinds are ignored.
///
/// Throws std::runtime_error if the file cannot be read, if it has no face, or if a line of those
/// two kinds is broken: a coordinate is not a finite double, there are fewer than three corners, or
/// an index is no vertex's. The text is one line. It begins with the file and, for a broken line,
/// its number: "a.obj:12: …".
TriangleMesh read_obj(const std::string& path);

/// Reads the same from a stream.
/// name  stands for the file in messages
TriangleMesh read_obj(std::istream& stream, const std::string& name);

}  // namespace common
