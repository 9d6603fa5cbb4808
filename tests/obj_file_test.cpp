#include "common/geometry/obj_file.hpp"

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>
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
  CHECK(refusal(corners + "v nan 0 0\n") == "a.obj:4: this is not a finite number: 'nan'");
  CHECK(refusal(corners + "v 1 -inf 0\n") == "a.obj:4: this is not a finite number: '-inf'");
  CHECK(refusal(corners + "v 1 1e999 0\n") == "a.obj:4: this is not a finite number: '1e999'");
  CHECK(refusal(corners + "v 1 2x 0\n") == "a.obj:4: this is not a finite number: '2x'");
  CHECK(refusal(corners + "v 1 2\n") == "a.obj:4: expected three coordinates, got 2");
  CHECK(refusal(corners + "v 1 2 3 x\n") == "a.obj:4: this is not a finite number: 'x'");
  CHECK(refusal(corners + "v 0x1p3 2 3\n") == "a.obj:4: this is not a finite number: '0x1p3'");
  CHECK(refusal(corners + "v +-1 2 3\n") == "a.obj:4: this is not a finite number: '+-1'");
  CHECK(refusal(corners + "v 1 -1e999 0\n") == "a.obj:4: this is not a finite number: '-1e999'");
  CHECK(refusal(corners + "f 1 2\n") == "a.obj:4: expected three corners or more, got 2");
  CHECK(refusal(corners + "f 1 2 # 3\n") == "a.obj:4: expected three corners or more, got 2");
  CHECK(refusal(corners + "f 1 2 /3\n") == "a.obj:4: this is not an index: '/3'");
  CHECK(refusal(corners + "f 1 2 3/x\n") == "a.obj:4: this is not an index: '3/x'");
  CHECK(refusal(corners + "f 1 2 3/1/0\n") == "a.obj:4: this is not an index: '3/1/0'");
  CHECK(refusal(corners + "f 1 2 3/1/1/1\n") == "a.obj:4: this is not an index: '3/1/1/1'");
  CHECK(refusal(corners + "f 1 2 1.0\n") == "a.obj:4: this is not an index: '1.0'");
  CHECK(refusal(corners + "\nf 1 2 0\n") == "a.obj:5: this is not an index: '0'");
  CHECK(refusal(corners + "f 1 2 x\n") == "a.obj:4: this is not an index: 'x'");
  CHECK(refusal(corners + "f 1 2 3\nf 1 2 4\n") == "a.obj:5: vertex 4 of 3");
  CHECK(refusal(corners + "f 1 2 2147483647\n") == "a.obj:4: vertex 2147483647 of 3");
  CHECK(refusal(corners + "f 1 2 99999999999\n") == "a.obj:4: vertex 99999999999 of 3");
  CHECK(refusal(corners + "f 1 2 99999999999999999999\n") ==
        "a.obj:4: this is not an index: '99999999999999999999'");
  CHECK(refusal(corners + "f 1 2 -4\n") == "a.obj:4: vertex -4 of 3");
  CHECK(refusal(corners + "v 1 2 \\\nx\nf 1 2 9\n") == "a.obj:4: this is not a finite number: 'x'");
  CHECK(refusal(corners + "v 1 2 \\\n3\nf 1 2 9\n") == "a.obj:6: vertex 9 of 4");
}

TEST_CASE("An OBJ file may have a mark and comments and lines that go on", "[obj]") {
  const std::array<std::uint32_t, 3> whole{0, 1, 2};
  for (const std::string& text :
       {"\xEF\xBB\xBF" + corners + "v 9 9 9\nf 1 2 3\n", corners + "f 1 2 3 # the only one\n",
        corners + "f 1 2 3# so is this\n", corners + "f 1 2 \\\n3\n", corners + "f 1 2 \\\r\n3\r\n",
        corners + "f 1/1/ 2/1/ 3/1/\n", corners + "f 1// 2// 3//\n", corners + "f -3/ -2// -1/5/\n",
        "f 1 2 3\n" + corners, corners + "f 1 2 3"}) {
    const TriangleMesh mesh = read(text);
    INFO(text);
    CHECK(mesh.vertices[0] == Vec3::Zero());
    REQUIRE(mesh.triangles.size() == 1);
    CHECK(mesh.triangles[0] == whole);
  }
}

TEST_CASE("A coordinate of an OBJ file is the nearest double", "[obj]") {
  const TriangleMesh mesh = read(
      "v 0.7 1.1 3.14159265358979323846\nv 9007199254740993 0.1234567890123456789 1e23\n"
      "v 1.7976931348623157e308 5e-324 2.2250738585072014e-308\nv 1e-999 -1e-999 1e-330\nf 1 2 "
      "3\n");
  CHECK(mesh.vertices[0] == Vec3(0.7, 1.1, 3.14159265358979323846));
  CHECK(mesh.vertices[1] == Vec3(9007199254740992.0, 0.1234567890123456789, 1e23));
  CHECK(mesh.vertices[2] == Vec3(1.7976931348623157e308, 5e-324, 2.2250738585072014e-308));
  CHECK(mesh.vertices[3] == Vec3::Zero());
  std::mt19937_64 engine(5);
  for (int i = 0; i < 3000; ++i) {
    double want = 0.0;
    while (!std::isnormal(want)) want = std::bit_cast<double>(engine());
    char line[100];
    std::snprintf(line, sizeof line, "v %.17g 0 0\n", want);
    CHECK(read(line + corners + "f 2 3 4\n").vertices[0].x() == want);
  }
}

namespace {

/// Twice the area that triangles cover, signed: those turned the other way count against it.
double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = triangle(mesh, i);
    area += (t[1] - t[0]).cross(t[2] - t[0]).z();
  }
  return area;
}

double unsigned_area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = triangle(mesh, i);
    area += (t[1] - t[0]).cross(t[2] - t[0]).norm();
  }
  return area;
}

}  // namespace

TEST_CASE("A polygon of an OBJ file is cut into triangles inside it", "[obj]") {
  struct Case {
    std::string text;
    std::size_t triangles;
    double area;  ///< twice that of the polygon, worked by hand
  };
  for (const Case& c :
       {Case{"v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n", 2, 4.0},
        Case{"v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 3 0\nf 1 2 3 4\n", 2, 4.0},  // a dart
        Case{"v 1 3 0\nv 0 0 0\nv 1 1 0\nv 2 0 0\nf 1 2 3 4\n", 2, 4.0},
        Case{"v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n"
             "f 1 2 3 4 5 6 7 8\n",
             6, 14.0},  // a U
        Case{"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n", 3, 8.0}}) {
    INFO(c.text);
    const TriangleMesh mesh = read(c.text);
    CHECK(mesh.triangles.size() == c.triangles);
    CHECK(area_of(mesh) == c.area);
    CHECK(unsigned_area_of(mesh) == c.area);  // none is turned over
  }
  const TriangleMesh reversed = read("v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 3 0\nf 4 3 2 1\n");
  CHECK(area_of(reversed) == -4.0);
  const TriangleMesh line = read("v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3 4\n");
  CHECK(line.triangles.size() == 2);
}

TEST_CASE("An OBJ file that is not there is named", "[obj]") {
  CHECK_THROWS_WITH(read_obj("/nowhere/a.obj"), "/nowhere/a.obj: cannot be opened");
}
