#include <rtcore.h>  // of Embree 3 or 4

#include <cmath>
#include <stdexcept>

#include "peers.hpp"

namespace lab::bvh_traversal {
namespace {

/// Embree needs a device. It uses one thread, as all others do.
RTCDevice device() {
  struct Device {
    RTCDevice handle = rtcNewDevice("threads=1");
    Device() = default;
    ~Device() { rtcReleaseDevice(handle); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
  };
  static const Device one;
  if (one.handle == nullptr) throw std::runtime_error("Embree: no device can be made");
  return one.handle;
}

/// Rounds to the next float outward, because Embree's boxes are floats.
float below(double value) {
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}
float above(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

/// A mesh as a geometry of the user's own, the only kind that rtcCollide takes.
class Tree {
 public:
  explicit Tree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(triangles_.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device());
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~Tree() { rtcReleaseScene(scene_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  [[nodiscard]] RTCScene scene() const { return scene_; }
  [[nodiscard]] const Triangle& operator[](std::size_t index) const { return triangles_[index]; }

 private:
  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    const Tree& tree = *static_cast<const Tree*>(arguments->geometryUserPtr);
    const Box box = box_of(tree.triangles_[arguments->primID]);
    *arguments->bounds_o = {below(box.low.x()),  below(box.low.y()),  below(box.low.z()),  0.0F,
                            above(box.high.x()), above(box.high.y()), above(box.high.z()), 0.0F};
  }

  std::vector<Triangle> triangles_;
  RTCScene scene_ = nullptr;
};

std::vector<Triangle> triangles_of(const TriangleMesh& mesh, const RigidTransform& pose) {
  std::vector<Triangle> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    triangles[i] = common::transformed(pose, triangle(mesh, i));
  }
  return triangles;
}

/// Each pair whose boxes overlap goes to the lab's own triangles_meet.
class EmbreeTrees : public PeerTrees {
 public:
  EmbreeTrees(const TriangleMesh& a, const TriangleMesh& b)
      : mesh_b_(b), a_(triangles_of(a, {})), b_(std::make_unique<Tree>(triangles_of(b, {}))) {
    // If triangles_meet is not written yet, it must throw here, not through Embree.
    static_cast<void>(triangles_meet(a_[0], (*b_)[0]));
  }

  void place(const RigidTransform& a_from_b) override {
    b_ = std::make_unique<Tree>(triangles_of(mesh_b_, a_from_b));
  }

  Intersections find() override {
    found_ = {};
    rtcCollide(a_.scene(), b_->scene(), collide, this);
    return std::move(found_);
  }

 private:
  static void collide(void* user, RTCCollision* collisions, unsigned count) {
    EmbreeTrees& trees = *static_cast<EmbreeTrees*>(user);
    trees.found_.triangle_tests += count;
    for (unsigned i = 0; i < count; ++i) {
      const TrianglePair pair{collisions[i].primID0, collisions[i].primID1};
      if (triangles_meet(trees.a_[pair.a], (*trees.b_)[pair.b])) trees.found_.pairs.push_back(pair);
    }
  }

  TriangleMesh mesh_b_;
  Tree a_;
  std::unique_ptr<Tree> b_;
  Intersections found_;
};

}  // namespace

Peer embree_peer() {
  return {"Embree " RTC_VERSION_STRING ", rtcCollide", "libembree-dev",
          [](const TriangleMesh& a, const TriangleMesh& b) {
            return std::make_unique<EmbreeTrees>(a, b);
          }};
}

}  // namespace lab::bvh_traversal
