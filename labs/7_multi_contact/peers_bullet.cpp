#include <btBulletDynamicsCommon.h>

#include <list>

#include "peers.hpp"

namespace lab::multi_contact {
namespace {

using common::Vec3;

constexpr double touching = 1.0 + 2e-6;  // else rounding would part what touches
constexpr btScalar mass = 1;
constexpr btScalar dt = btScalar(1) / 60;

btScalar real(double value) { return static_cast<btScalar>(value); }

btVector3 to_bullet(const Vec3& v) { return {real(v.x()), real(v.y()), real(v.z())}; }

class BulletWorld : public PeerWorld {
 public:
  explicit BulletWorld(const PeerBalls& balls)
      : balls_(balls), sphere_(real(touching * balls.radius)) {
    world_.setGravity({0, 0, 0});
    world_.getSolverInfo().m_erp2 = 0;
    world_.getSolverInfo().m_solverMode &= ~SOLVER_USE_WARMSTARTING;  // each step is a first one
    for (const Wall& wall : balls.walls) {
      planes_.emplace_back(to_bullet(wall.normal), real(wall.offset));
      add(0, &planes_.back(), {0, 0, 0});
    }
    btVector3 inertia;
    sphere_.calculateLocalInertia(mass, inertia);
    for (std::size_t i = 0; i < balls.centers.size(); ++i) add(mass, &sphere_, inertia);
  }
  ~BulletWorld() override {
    for (btRigidBody& body : bodies_) world_.removeRigidBody(&body);
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void step(int iterations) override {
    world_.getSolverInfo().m_numIterations = iterations;
    auto body = std::next(bodies_.begin(), static_cast<std::ptrdiff_t>(balls_.walls.size()));
    for (std::size_t i = 0; i < balls_.centers.size(); ++i, ++body) {
      const btTransform place(btQuaternion::getIdentity(), to_bullet(balls_.centers[i]));
      body->setCenterOfMassTransform(place);
      body->setLinearVelocity(to_bullet(balls_.velocities[i]));
      body->setAngularVelocity({0, 0, 0});
    }
    world_.stepSimulation(dt, 0);  // no substeps: this one step, of dt
  }

  [[nodiscard]] std::vector<Vec3> velocities() const override {
    std::vector<Vec3> all;
    for (const btRigidBody& body : bodies_) {
      const btVector3& v = body.getLinearVelocity();
      if (!body.isStaticObject()) all.emplace_back(v.x(), v.y(), v.z());
    }
    return all;
  }

 private:
  void add(btScalar its_mass, btCollisionShape* shape, const btVector3& inertia) {
    btRigidBody& body = bodies_.emplace_back(its_mass, nullptr, shape, inertia);
    body.setFriction(0);
    body.setRestitution(0);
    body.setDamping(0, 0);
    body.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&body);
  }

  PeerBalls balls_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btSphereShape sphere_;
  std::list<btStaticPlaneShape> planes_;
  std::list<btRigidBody> bodies_;  // planes, then balls; they must not move in memory
};

}  // namespace

Peer bullet_peer() {
  const int version = btGetVersion();  // 324 is 3.24
  const char* const precision = sizeof(btScalar) == sizeof(double) ? "double" : "single";
  return {"Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100) + ", " +
              precision,
          "libbullet-dev", btContactSolverInfo().m_numIterations,
          [](const PeerBalls& balls) { return std::make_unique<BulletWorld>(balls); }};
}

}  // namespace lab::multi_contact
