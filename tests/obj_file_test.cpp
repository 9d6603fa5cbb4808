#include "common/obj_file.hpp"

#include <sstream>

#include "catch.hpp"

using namespace common;

namespace {

TriangleMesh read(const std::string& text) {
  std::istringstream stream(text);
  return read_obj(stream, "a.obj");
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "it is read";
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("An OBJ file gives its vertices in double and its triangles", "[obj]") {
  const TriangleMesh mesh = read(
      "# two\nmtllib none.mtl\nv 0.1 -2e-3 +4\nv 1 0 0 1\r\n"
      "\tv  0 1 0\nvt 0 1\nvn 0 0 1\ng part\ns off\nusemtl red\n"
      "f 1 2 3\nf 3/1/1 2//1 -3/1\n");
  REQUIRE(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[0] == Vec3(0.1, -2e-3, 4.0));
  REQUIRE(mesh.triangles.size() == 2);
  CHECK(mesh.triangles[0] == std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{2, 1, 0});
}

TEST_CASE("A broken OBJ file is refused in one line that names the place", "[obj]") {
  CHECK(refusal("") == "a.obj: it has no triangle");
  CHECK(refusal(corners) == "a.obj: it has no triangle");
  CHECK(refusal(corners + "v nan 0 0\n") == "a.obj:4: this is no finite number: 'nan'");
  CHECK(refusal(corners + "v 1 -inf 0\n") == "a.obj:4: this is no finite number: '-inf'");
  CHECK(refusal(corners + "v 1 1e999 0\n") == "a.obj:4: this is no finite number: '1e999'");
  CHECK(refusal(corners + "v 1 2x 0\n") == "a.obj:4: this is no finite number: '2x'");
  CHECK(refusal(corners + "v 1 2\n") == "a.obj:4: want three coordinates, got 2");
  CHECK(refusal(corners + "f 1 2 3 1\n") == "a.obj:4: want a triangle, got a face of 4 corners");
  CHECK(refusal(corners + "f 1 2\n") == "a.obj:4: want a triangle, got a face of 2 corners");
  CHECK(refusal(corners + "\nf 1 2 0\n") == "a.obj:5: this is no index: '0'");
  CHECK(refusal(corners + "f 1 2 x\n") == "a.obj:4: this is no index: 'x'");
  CHECK(refusal(corners + "f 1 2 3\nf 1 2 4\n") == "a.obj:5: vertex 4 of 3");
  CHECK(refusal(corners + "f 1 2 2147483647\n") == "a.obj:4: vertex 2147483647 of 3");
  CHECK(refusal(corners + "f 1 2 99999999999\n") == "a.obj:4: this is no index: '99999999999'");
  const std::string before_the_first = refusal(corners + "f 1 2 -4\n");
  CHECK(before_the_first.starts_with("a.obj:"));
  CHECK(before_the_first.find('4') != std::string::npos);
}

TEST_CASE("An OBJ file that is not there is named", "[obj]") {
  CHECK_THROWS_WITH(read_obj("/nowhere/a.obj"), "/nowhere/a.obj: cannot be opened");
}
