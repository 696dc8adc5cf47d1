// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bullet_heap.h"

#ifdef SCREE_HAS_BULLET

#include "bench/measure.h"
#include "core/random.h"

#include <BulletCollision/CollisionShapes/btShapeHull.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>

namespace scree::bench {

namespace {

// Bullet works best with bodies of about one metre, so a component is scaled to length 1.
std::unique_ptr<btConvexHullShape> hull_of(const Mesh& mesh) {
    const Box3 box = bounds(mesh);
    const Vec3 size = box.size();
    const float scale = 1 / std::max({size.x, size.y, size.z});
    btConvexHullShape all;
    for (const Vec3& p : mesh.positions) {
        const Vec3 q = (p - box.center()) * scale;
        all.addPoint(btVector3(q.x, q.y, q.z), false);
    }
    all.recalcLocalAabb();
    btShapeHull hull(&all); // reduces it to 42 points
    hull.buildHull(0);
    auto shape = std::make_unique<btConvexHullShape>();
    for (int i = 0; i < hull.numVertices(); ++i)
        shape->addPoint(hull.getVertexPointer()[i], false);
    shape->recalcLocalAabb();
    shape->setMargin(0.01F);
    return shape;
}

/// A world with bodies in a box that is open at the top.
class Heap {
  public:
    Heap(const Mesh& mesh, int count) : shape_(hull_of(mesh)) {
        world_.setGravity(btVector3(0, -10, 0));
        const auto side = static_cast<float>(std::cbrt(double(count)));
        const float wide = 0.6F * side;
        add_wall({0, 1, 0}, 0);
        for (const float sign : {-1.0F, 1.0F}) {
            add_wall({sign, 0, 0}, -wide);
            add_wall({0, 0, sign}, -wide);
        }
        btVector3 inertia;
        shape_->calculateLocalInertia(1, inertia);
        Random random(1, Purpose::test);
        const int row = std::max(1, static_cast<int>(2 * wide - 0.2F));
        for (int i = 0; i < count; ++i) {
            const auto place = [&](int cell) { return float(cell) - 0.5F * float(row - 1); };
            const btVector3 at(place(i % row), 1 + float(i / (row * row)), place(i / row % row));
            const btQuaternion turn =
                btQuaternion(btVector3(random.uniform_float() - 0.5F, random.uniform_float() - 0.5F,
                                       random.uniform_float() + 0.01F)
                                 .normalized(),
                             6.2831853F * random.uniform_float());
            add_body(1, shape_.get(), btTransform(turn, at), inertia);
        }
        bodies_ = count;
    }
    ~Heap() {
        for (const auto& body : all_)
            world_.removeRigidBody(body.get());
    }
    Heap(const Heap&) = delete;
    Heap& operator=(const Heap&) = delete;

    void advance() { world_.stepSimulation(1.0F / 60, 4, 1.0F / 240); }

    double mean_speed() const {
        double sum = 0;
        for (const auto& body : all_)
            sum += double(body->getLinearVelocity().length());
        return sum / bodies_;
    }

    double deepest() {
        double depth = 0;
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            const btPersistentManifold* contacts = dispatcher_.getManifoldByIndexInternal(i);
            for (int k = 0; k < contacts->getNumContacts(); ++k)
                depth = std::max(depth, -double(contacts->getContactPoint(k).getDistance()));
        }
        return depth;
    }

  private:
    void add_wall(const btVector3& normal, float offset) {
        walls_.push_back(std::make_unique<btStaticPlaneShape>(normal, offset));
        add_body(0, walls_.back().get(), btTransform::getIdentity(), {0, 0, 0});
    }
    void add_body(float mass, btCollisionShape* shape, const btTransform& at,
                  const btVector3& inertia) {
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
        info.m_startWorldTransform = at;
        info.m_friction = 0.5F;
        all_.push_back(std::make_unique<btRigidBody>(info));
        world_.addRigidBody(all_.back().get());
    }

    std::unique_ptr<btConvexHullShape> shape_;
    std::vector<std::unique_ptr<btStaticPlaneShape>> walls_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btRigidBody>> all_;
    int bodies_ = 0;
};

} // namespace

std::optional<BulletHeap> drop_with_bullet(const Mesh& mesh, int count) {
    BulletHeap found;
    Heap heap(mesh, count);
    found.cpu_seconds = cpu_seconds_of([&] {
        for (int frame = 1; frame <= 8 * 60; ++frame) {
            heap.advance();
            found.simulated_seconds = frame / 60.0;
            found.speed = heap.mean_speed();
            if (frame > 60 && found.speed < 0.1)
                break;
        }
    });
    found.deepest = heap.deepest();
    return found;
}

} // namespace scree::bench

#else

namespace scree::bench {

std::optional<BulletHeap> drop_with_bullet(const Mesh& /*mesh*/, int /*count*/) { return {}; }

} // namespace scree::bench

#endif
