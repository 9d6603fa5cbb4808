#include <btBulletDynamicsCommon.h>

#include "peers.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

using common::Quat;
using common::Spin;
using common::Vec3;

constexpr btScalar mass = 1;
constexpr btScalar radius = 0.5;

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btQuaternion to_bullet(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

class BulletBody : public PeerBody {
 public:
  BulletBody(const Vec3& moments, const Spin& start, double dt)
      : dt_(static_cast<btScalar>(dt)), body_(mass, nullptr, &sphere_, to_bullet(moments)) {
    world_.setGravity({0, 0, 0});
    body_.setDamping(0, 0);
    body_.setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    body_.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&body_);
    BulletBody::place(start);
  }
  ~BulletBody() override { world_.removeRigidBody(&body_); }
  BulletBody(const BulletBody&) = delete;
  BulletBody& operator=(const BulletBody&) = delete;

  void place(const Spin& spin) override {
    body_.setCenterOfMassTransform(btTransform(to_bullet(spin.world_from_body)));
    body_.setLinearVelocity({0, 0, 0});
    body_.setAngularVelocity(to_bullet(spin.world_from_body * spin.angular_velocity_body));
  }

  void step(const Vec3& torque) override {
    body_.applyTorque(to_bullet(torque));
    world_.stepSimulation(dt_, 0);  // no substeps: this one step, of dt
  }

  [[nodiscard]] Quat world_from_body() const override {
    const btQuaternion q = body_.getOrientation();
    return Quat(q.w(), q.x(), q.y(), q.z()).normalized();
  }

  [[nodiscard]] Spin spin() const override {
    const btVector3& omega = body_.getAngularVelocity();
    const Quat q = world_from_body();
    return {q, q.conjugate() * Vec3(omega.x(), omega.y(), omega.z())};
  }

 private:
  btScalar dt_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btSphereShape sphere_{radius};
  btRigidBody body_;
};

}  // namespace

Peer bullet_peer() {
  const int version = btGetVersion();  // 324 is 3.24
  const char* const precision = sizeof(btScalar) == sizeof(double) ? "double" : "single";
  return {"Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) + ", " +
              precision,
          "libbullet-dev", [](const Vec3& moments, const Spin& start, double dt) {
            return std::make_unique<BulletBody>(moments, start, dt);
          }};
}

}  // namespace lab::gyroscopic_tumbling
