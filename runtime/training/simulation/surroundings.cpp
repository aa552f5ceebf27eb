#include "runtime/training/simulation/surroundings.h"

#include <algorithm>
#include <numbers>

#include "plugins/world/ground.h"
#include "runtime/training/simulation/solid_shape.h"

namespace runtime {
namespace {

OdeGeom MakePlane(const Vector3& normal) {
  return OdeGeom(dCreatePlane(nullptr, normal[0], normal[1], normal[2], 0));
}

}  // namespace

Surroundings::Surroundings(const world::WorldDescription* world, dWorldID ode, RobotBody& body)
    : world_(world) {
  AddGround();
  for (const world::Thing& thing : things()) AddThing(thing, ode, body);
}

bool Surroundings::IsFlat() const {
  return world_ == nullptr || std::holds_alternative<world::Plane>(world_->ground.shape);
}

double Surroundings::HeightAt(double x, double y) const {
  return world_ == nullptr ? 0 : world::HeightAt(world_->ground, x, y);
}

std::span<const world::Thing> Surroundings::things() const {
  if (world_ == nullptr) return {};
  return world_->things;
}

dGeomID Surroundings::GeomOf(size_t thing, const RobotBody& body) const {
  return bodies_[thing] < 0 ? fixed_geoms_[thing].get() : body.geom(bodies_[thing]);
}

void Surroundings::AddGround() {
  const Vector3 normal =
      world_ == nullptr ? Vector3::UnitZ() : ToEigen(world::NormalOf(world_->ground).data());
  GroundPart& plane = ground_.emplace_back();
  plane.geom = MakePlane(normal);
  plane.normal = normal;
  if (world_ == nullptr) return;
  AddSteps();
  if (const auto* map = std::get_if<world::HeightMap>(&world_->ground.shape)) AddHills(*map);
}

void Surroundings::AddSteps() {
  for (const world::Block& block : world::BlocksOf(world_->ground)) {
    GroundPart& part = ground_.emplace_back();
    const double height = block.height + kGroundDepth;
    part.geom.reset(dCreateBox(nullptr, block.high_x - block.low_x, world::kWidth, height));
    dGeomSetPosition(part.geom.get(), (block.low_x + block.high_x) / 2, 0,
                     block.height - height / 2);
    part.offset = block.height;
    part.low_x = block.low_x;
    part.high_x = block.high_x;
  }
}

// ODE's hills have y up and z to the near side: turned about x, their rows go the other way.
void Surroundings::AddHills(const world::HeightMap& map) {
  std::vector<double> heights;
  for (int row = map.rows; row-- > 0;) {
    for (int column = 0; column < map.columns; ++column) heights.push_back(map.At(column, row));
  }
  hills_.reset(dGeomHeightfieldDataCreate());
  constexpr int kCopy = 1, kOnce = 0;
  dGeomHeightfieldDataBuildDouble(hills_.get(), heights.data(), kCopy, map.size_x, map.size_y,
                                  map.columns, map.rows, 1, 0, kGroundDepth, kOnce);
  GroundPart& part = ground_.emplace_back();
  part.geom.reset(dCreateHeightfield(nullptr, hills_.get(), 1));
  dMatrix3 rotation;
  dRFromAxisAndAngle(rotation, 1, 0, 0, std::numbers::pi / 2);
  dGeomSetRotation(part.geom.get(), rotation);
  dGeomSetPosition(part.geom.get(), map.center_x, map.center_y, 0);
  part.offset = *std::ranges::max_element(map.heights);
  part.low_x = map.center_x - map.size_x / 2;
  part.high_x = map.center_x + map.size_x / 2;
}

void Surroundings::AddThing(const world::Thing& thing, dWorldID ode, RobotBody& body) {
  OdeGeom geom = runtime::GeomOf(thing.shape);
  if (thing.is_fixed) {
    FixShape(thing.shape, thing.position, thing.orientation, geom.get());
    bodies_.push_back(-1);
    fixed_geoms_.push_back(std::move(geom));
    return;
  }
  OdeBody moving(dBodyCreate(ode));
  const dMass mass = MassOfShape(thing.shape, thing.mass);
  dBodySetMass(moving.get(), &mass);
  const robot::Vector3& p = thing.position;
  const auto& [w, x, y, z] = thing.orientation;
  const dQuaternion orientation = {w, x, y, z};
  dBodySetPosition(moving.get(), p[0], p[1], p[2]);
  dBodySetQuaternion(moving.get(), orientation);
  dGeomSetBody(geom.get(), moving.get());
  PlaceShape(thing.shape, geom.get());
  bodies_.push_back(body.body_count());
  fixed_geoms_.emplace_back();
  body.AddThing(std::move(moving), std::move(geom));
}

}  // namespace runtime
