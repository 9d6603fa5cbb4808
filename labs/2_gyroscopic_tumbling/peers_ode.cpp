#include <ode/ode.h>
#include <ode/version.h>

#include "peers.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

using common::Quat;
using common::Spin;
using common::Vec3;

/// ODE must be started once and stopped at the end.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

dReal real(double value) { return static_cast<dReal>(value); }

class OdeBody : public PeerBody {
 public:
  OdeBody(const Vec3& moments, const Spin& start, double dt) : dt_(real(dt)) {
    static const Library library;
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, 0);
    dWorldSetAutoDisableFlag(world_, 0);
    body_ = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, real(moments.x()), real(moments.y()), real(moments.z()),
                       0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetGyroscopicMode(body_, 1);
    OdeBody::place(start);
  }
  ~OdeBody() override { dWorldDestroy(world_); }
  OdeBody(const OdeBody&) = delete;
  OdeBody& operator=(const OdeBody&) = delete;

  void place(const Spin& spin) override {
    const Quat& q = spin.world_from_body;
    const Vec3 omega = q * spin.angular_velocity_body;
    const dQuaternion ode_q = {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
    dBodySetPosition(body_, 0, 0, 0);
    dBodySetLinearVel(body_, 0, 0, 0);
    dBodySetQuaternion(body_, ode_q);
    dBodySetAngularVel(body_, real(omega.x()), real(omega.y()), real(omega.z()));
  }

  void step(const Vec3& torque) override {
    dBodyAddTorque(body_, real(torque.x()), real(torque.y()), real(torque.z()));
    dWorldStep(world_, dt_);
  }

  [[nodiscard]] Quat world_from_body() const override {
    const dReal* q = dBodyGetQuaternion(body_);
    return Quat(q[0], q[1], q[2], q[3]).normalized();
  }

  [[nodiscard]] Spin spin() const override {
    const dReal* omega = dBodyGetAngularVel(body_);
    const Quat q = world_from_body();
    return {q, q.conjugate() * Vec3(omega[0], omega[1], omega[2])};
  }

 private:
  dReal dt_;
  dWorldID world_ = nullptr;
  dBodyID body_ = nullptr;
};

}  // namespace

Peer ode_peer() {
  const char* const precision = sizeof(dReal) == sizeof(double) ? "double" : "single";
  return {std::string("ODE " dODE_VERSION ", ") + precision, "libode-dev",
          [](const Vec3& moments, const Spin& start, double dt) {
            return std::make_unique<OdeBody>(moments, start, dt);
          }};
}

}  // namespace lab::gyroscopic_tumbling
