#pragma once
// What crosses between the judge and a worker that runs a student's code: fixed-size records of plain numbers
// on two descriptors the judge owns. C++14 and free of every other header of rigor, because the driver that is
// compiled together with a submission includes it too.
#include <cstdint>

namespace rigor {
namespace grader {

/// The student's functions, by what a request asks for.
enum class Function : std::uint32_t {
  body_inertia = 0,      // construct body A; reply: its two private tensors (A.body_inertia, A.body_inverse_inertia)
  world_inertia = 1,     // reply.world_inertia, reply.world_inverse_inertia of A
  apply_force = 2,       // A.applyForce(point, vector); reply: A
  update = 3,            // A.update(h), `count` times; reply: A
  friction_tangent = 4,  // plane.frictionTangent(A, point); reply.vector, and A to see that it is untouched
  plane_response = 5,    // plane.applyCollisionResponse(A); reply: A
  pair_response = 6,     // applyCollisionImpulse(A, B, point, vector = normal from A to B); reply: A and B
  scene_steps = 7,       // the student's own ParticleSystem after srand(seed), `count` steps of h; reply.scene
  constants = 8,         // reply.constants: the values the submission was compiled with
};

/// Bits of Request::flags.
constexpr std::uint32_t want_helpers = 1;   // before the call: what the student's own helpers say of A and B as they
                                            // stand (Reply::A_helpers, B_helpers; tangent in Reply::vector where
                                            // there is a plane: its frictionTangent at `point`)
constexpr std::uint32_t hold_forces = 2;    // update: the accumulators are set again before each of `count` steps
constexpr std::uint32_t vacuum_on = 4;      // scene_steps: startVacuumForces() before the first step
constexpr std::uint32_t tensor_only = 8;    // world_inertia: the other of the two replies stays zero
constexpr std::uint32_t inverse_only = 16;

/// One cuboid, SI units, world axes unless said; matrices by rows.
struct BodyRecord {
  double size[3];  // full edge lengths: width, height, depth
  double mass;
  double position[3];
  double rotation[9];  // body to world
  double velocity[3];
  double spin[3];
  double net_force[3];
  double net_torque[3];
  double body_inertia[9];          // set directly by the driver when `direct` is 1 in the request
  double body_inverse_inertia[9];
};

struct Request {
  std::uint32_t magic;  // request_magic
  std::uint32_t function;
  std::uint64_t serial;  // the reply repeats it
  std::uint32_t count;
  std::uint32_t direct;  // 1: the driver overwrites state, accumulators and tensors with the record's values
                         // 0: only what the constructor takes (size, mass, position, rotation), then state
  std::uint32_t flags;
  std::uint32_t seed;
  double h;
  BodyRecord A, B;
  double plane_point[3], plane_normal[3];
  double point[3];
  double vector[3];
};

enum class Status : std::uint32_t {
  done = 0,
  unknown_function = 1,  // the submission has no such function
  threw = 2,             // an exception came out of the student's function
  out_of_memory = 3,     // std::bad_alloc came out of it
  crashed = 4,           // last words from a signal handler: Reply::signal, Reply::stack_overflow
};

constexpr int scene_samples = 60;

/// What the student's own functions gave for a body just before the call (want_helpers).
struct HelperRecord {
  double world_inertia[9], world_inverse_inertia[9];
};

struct Reply {
  std::uint32_t magic;  // reply_magic
  std::uint32_t status;
  std::uint64_t serial;
  std::uint32_t signal;
  std::uint32_t stack_overflow;
  BodyRecord A, B;
  HelperRecord A_helpers, B_helpers;
  double world_inertia[9], world_inverse_inertia[9];
  double vector[3];
  double constants[4];  // restitution, static friction, dynamic friction, DELTA_T
  // scene, over the steps after the first tenth (cuboids may start outside): smallest signed distance of a centre
  // to a plane, largest speed, largest |position|; then 1 when everything stayed finite from the start, else 0
  double scene[4];
  double trace[scene_samples][4];  // scene, for a picture, after each of as many equal parts: s, energy, |P|, |L about the origin|
  char text[96];  // Status::threw: what the exception said, clipped, ends with 0
};

constexpr std::uint32_t request_magic = 0x72677131u;
constexpr std::uint32_t reply_magic = 0x72677231u;

}  // namespace grader
}  // namespace rigor
