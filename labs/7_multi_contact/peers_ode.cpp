#include <ode/ode.h>
#include <ode/version.h>

#include <array>

#include "peers.hpp"

namespace lab::multi_contact {
namespace {

using common::Vec3;

constexpr double dt = 1.0 / 60.0;

/// ODE wants to be started once and stopped at the end.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

dReal real(double value) { return static_cast<dReal>(value); }

class OdeWorld : public PeerWorld {
 public:
  explicit OdeWorld(const PeerBalls& balls) : balls_(balls) {
    static const Library library;
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0, 0, 0);
    dWorldSetERP(world_, 0);
    dWorldSetAutoDisableFlag(world_, 0);
    for (const Wall& wall : balls.walls) {
      const Vec3& n = wall.normal;
      dCreatePlane(space_, real(n.x()), real(n.y()), real(n.z()), real(wall.offset));
    }
    dMass mass;
    dMassSetSphereTotal(&mass, 1, real(balls.radius));
    for (std::size_t i = 0; i < balls.centers.size(); ++i) {
      bodies_.push_back(dBodyCreate(world_));
      dBodySetMass(bodies_.back(), &mass);
      constexpr double touching = 1.0 + 1e-9;  // else rounding would part what touches
      dGeomSetBody(dCreateSphere(space_, real(touching * balls.radius)), bodies_.back());
    }
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  void step(int iterations) override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vec3& x = balls_.centers[i];
      const Vec3& v = balls_.velocities[i];
      dBodySetPosition(bodies_[i], real(x.x()), real(x.y()), real(x.z()));
      dBodySetLinearVel(bodies_[i], real(v.x()), real(v.y()), real(v.z()));
      dBodySetAngularVel(bodies_[i], 0, 0, 0);
    }
    dJointGroupEmpty(contacts_);
    dSpaceCollide(space_, this, &OdeWorld::add_contact);
    dWorldSetQuickStepNumIterations(world_, iterations);
    dWorldQuickStep(world_, real(dt));
  }

  [[nodiscard]] std::vector<Vec3> velocities() const override {
    std::vector<Vec3> all;
    for (dBodyID body : bodies_) {
      const dReal* const v = dBodyGetLinearVel(body);
      all.emplace_back(v[0], v[1], v[2]);
    }
    return all;
  }

 private:
  static void add_contact(void* self, dGeomID a, dGeomID b) {
    const auto* const world = static_cast<OdeWorld*>(self);
    dContact contact{};  // no friction, no bounce
    if (dCollide(a, b, 1, &contact.geom, sizeof contact) == 0) return;
    dJointID joint = dJointCreateContact(world->world_, world->contacts_, &contact);
    dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
  }

  PeerBalls balls_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> bodies_;
};

}  // namespace

Peer ode_peer() {
  const char* const precision = sizeof(dReal) == sizeof(double) ? "double" : "single";
  return {std::string("ODE " dODE_VERSION ", ") + precision, "libode-dev", 20,
          [](const PeerBalls& balls) { return std::make_unique<OdeWorld>(balls); }};
}

}  // namespace lab::multi_contact
