// Compiled together with one submission: reads requests on descriptor 3, puts the cuboids into the state asked for,
// calls the student's function, writes what came out on descriptor 4. It holds no expected value and judges nothing.
// C++14, access control off (the tensors are private); a missing member is an answer (unknown_function), no error.
#include <fenv.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <new>

#include "CollisionPlane.h"
#include "Constants.h"
#include "Cuboid.h"
#include "MatrixUtils.h"
#include "ParticleSystem.h"
#include "protocol.hpp"

namespace {

using namespace rigor::grader;

constexpr int requests = 3, replies = 4;
Reply reply;

// ---- Pipes

bool read_whole(int fd, void* to, size_t size) {
  for (char* at = static_cast<char*>(to); size > 0;) {
    const ssize_t n = ::read(fd, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    size -= size_t(n);
  }
  return true;
}

bool write_whole(int fd, const void* from, size_t size) {
  for (const char* at = static_cast<const char*>(from); size > 0;) {
    const ssize_t n = ::write(fd, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    size -= size_t(n);
  }
  return true;
}

// ---- Last words: a crash is named by its signal, and endless recursion by where it hit

char* stack_top = nullptr;
size_t stack_size = 0;
char signal_stack[64 << 10];

void last_words(int number, siginfo_t* info, void*) {
  const char* at = static_cast<const char*>(info->si_addr);
  const char* low = stack_top - stack_size;
  reply.status = std::uint32_t(Status::crashed);
  reply.signal = std::uint32_t(number);
  reply.stack_overflow = number == SIGSEGV && at > low - (1 << 20) && at < low + (64 << 10);
  write_whole(replies, &reply, sizeof reply);
  _exit(99);
}

void listen_for_crashes() {
  char here;
  stack_top = &here;
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  stack_size = limit.rlim_cur == RLIM_INFINITY ? size_t(8) << 20 : size_t(limit.rlim_cur);
  stack_t other{};
  other.ss_sp = signal_stack;
  other.ss_size = sizeof signal_stack;
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_sigaction = last_words;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | int(SA_RESETHAND);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(number, &action, nullptr);
}

// ---- Values to and from records

template <class Vector>
void get(const Vector& from, double (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}
void get(const Matrix3x3& from, double (&to)[9]) {
  for (int i = 0; i < 9; ++i) to[i] = from(i / 3, i % 3);
}
V3D vector_of(const double (&from)[3]) { return V3D(from[0], from[1], from[2]); }
P3D point_of(const double (&from)[3]) { return P3D(from[0], from[1], from[2]); }
Matrix3x3 matrix_of(const double (&from)[9]) {
  Matrix3x3 m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = from[i];
  return m;
}

std::unique_ptr<Cuboid> body_of(const Request& r, const BodyRecord& b) {
  std::unique_ptr<Cuboid> c(
      new Cuboid(b.size[0], b.size[1], b.size[2], b.mass, point_of(b.position), matrix_of(b.rotation)));
  c->mass = b.mass;
  c->worldTranslation = vector_of(b.position);
  c->worldRotation = matrix_of(b.rotation);
  c->linearVelocity = vector_of(b.velocity);
  c->angularVelocity = vector_of(b.spin);
  c->netForce = vector_of(b.net_force);
  c->netTorque = vector_of(b.net_torque);
  if (r.direct) {
    c->bodyCoordsMOI = matrix_of(b.body_inertia);
    c->bodyCoordsInverseMOI = matrix_of(b.body_inverse_inertia);
  }
  return c;
}

void record(const BodyRecord& asked, const Cuboid& c, BodyRecord& to) {
  std::copy(asked.size, asked.size + 3, to.size);
  to.mass = c.mass;
  get(c.worldTranslation, to.position);
  get(c.worldRotation, to.rotation);
  get(c.linearVelocity, to.velocity);
  get(c.angularVelocity, to.spin);
  get(c.netForce, to.net_force);
  get(c.netTorque, to.net_torque);
  get(c.bodyCoordsMOI, to.body_inertia);
  get(c.bodyCoordsInverseMOI, to.body_inverse_inertia);
}

// ---- The student's functions. Each comes twice: the first is chosen where the class has the member.

#define RIGOR_CALL(name, parameters, call)                                       \
  template <class C>                                                             \
  auto name(C& c, RIGOR_LIST parameters, int)->decltype(call, Status::done) {    \
    call;                                                                        \
    return Status::done;                                                         \
  }                                                                              \
  template <class C>                                                             \
  Status name(C&, RIGOR_LIST parameters, long) {                                 \
    return Status::unknown_function;                                             \
  }
#define RIGOR_LIST(...) __VA_ARGS__

RIGOR_CALL(call_body_inertia, (int), c.computeBodyCoordsMOI())
RIGOR_CALL(call_world_inertia, (Matrix3x3 & out), out = c.computeWorldCoordsMOI())
RIGOR_CALL(call_world_inverse, (Matrix3x3 & out), out = c.computeWorldCoordsInverseMOI())
RIGOR_CALL(call_apply_force, (P3D & at, V3D& force), c.applyForce(at, force))
RIGOR_CALL(call_update, (double h), c.update(h))
RIGOR_CALL(call_tangent, (Cuboid & body, P3D& at, V3D& out), out = c.frictionTangent(body, at))
RIGOR_CALL(call_plane, (Cuboid & body), c.applyCollisionResponse(body))
RIGOR_CALL(call_pair, (Cuboid & a, Cuboid& b, P3D& at, V3D& n), c.applyCollisionImpulse(a, b, at, n))

void ask_helpers(Cuboid& c, HelperRecord& to) {
  Matrix3x3 inertia = Matrix3x3::Zero(), inverse = Matrix3x3::Zero();
  call_world_inertia(c, inertia, 0);
  call_world_inverse(c, inverse, 0);
  get(inertia, to.world_inertia);
  get(inverse, to.world_inverse_inertia);
}

GLShaderMaterial material;

void look_at(ParticleSystem& system, bool settled) {
  for (Cuboid* c : system.cubes) {
    const double values[] = {c->worldTranslation.norm(), c->linearVelocity.norm(), c->angularVelocity.norm(),
                             c->worldRotation.norm()};
    for (const double value : values)
      if (!std::isfinite(value)) reply.scene[3] = 0;
    if (!settled) continue;
    reply.scene[1] = std::max(reply.scene[1], values[1]);
    reply.scene[2] = std::max(reply.scene[2], values[0]);
    for (CollisionPlane& plane : system.planes) {
      const double gap = (c->worldTranslation - plane.pointOnPlane).dot(plane.normal);
      reply.scene[0] = std::min(reply.scene[0], gap);
    }
  }
}

// Energy and momenta by the cuboids' own numbers, for a picture in the report; nothing is judged by them.
void take_sample(ParticleSystem& system, double time, double (&sample)[4]) {
  double energy = 0;
  V3D momentum(0, 0, 0), angular(0, 0, 0);
  for (Cuboid* c : system.cubes) {
    const V3D x = c->worldTranslation, v = c->linearVelocity, w = c->angularVelocity;
    const V3D spin_momentum = c->worldRotation * (c->bodyCoordsMOI * (c->worldRotation.transpose() * w));
    energy += c->mass * v.dot(v) / 2 + w.dot(spin_momentum) / 2 + c->mass * 9.8 * x[1];
    momentum += c->mass * v;
    angular += spin_momentum + c->mass * x.cross(v);
  }
  sample[0] = time;
  sample[1] = energy;
  sample[2] = momentum.norm();
  sample[3] = angular.norm();
}

Status run_scene(const Request& r) {
  std::srand(r.seed);
  ParticleSystem system(&material);
  system.enableGravity = true;
  if (r.flags & vacuum_on) system.startVacuumForces();
  reply.scene[0] = HUGE_VAL;
  reply.scene[3] = 1;
  for (std::uint32_t step = 0; step < r.count && reply.scene[3] == 1; ++step) {
    system.integrate_PBF(r.h);
    look_at(system, step >= r.count / 10);
    const std::uint64_t samples = scene_samples, part = (step + 1) * samples / r.count;
    if (part > step * samples / r.count) take_sample(system, (step + 1) * r.h, reply.trace[part - 1]);
    else if (reply.scene[3] == 0) take_sample(system, (step + 1) * r.h, reply.trace[part]);  // when it blew up
  }
  return Status::done;
}

Status answer(const Request& r) {
  const Function function = Function(r.function);
  if (function == Function::constants) {
    const double values[] = {COEFF_RESITUTION, COEFF_STATIC_FRICTION, COEFF_DYNAMIC_FRICTION, DELTA_T};
    std::copy(values, values + 4, reply.constants);
    return Status::done;
  }
  if (function == Function::scene_steps) return run_scene(r);

  const std::unique_ptr<Cuboid> a = body_of(r, r.A);
  P3D at = point_of(r.point);
  V3D vector = vector_of(r.vector);
  Status status = Status::unknown_function;
  if (r.flags & want_helpers) ask_helpers(*a, reply.A_helpers);

  switch (function) {
    case Function::body_inertia:
      a->bodyCoordsMOI.setZero();  // so that a tensor left out is 0, not whatever was there
      a->bodyCoordsInverseMOI.setZero();
      status = call_body_inertia(*a, 0, 0);
      break;
    case Function::world_inertia: {
      Matrix3x3 inertia = Matrix3x3::Zero(), inverse = Matrix3x3::Zero();
      status = Status::done;  // one that does not return costs the other nothing
      if ((r.flags & inverse_only) == 0) status = call_world_inertia(*a, inertia, 0);
      if (status == Status::done && (r.flags & tensor_only) == 0) status = call_world_inverse(*a, inverse, 0);
      get(inertia, reply.world_inertia);
      get(inverse, reply.world_inverse_inertia);
      break;
    }
    case Function::apply_force:
      status = call_apply_force(*a, at, vector, 0);
      break;
    case Function::update:
      for (std::uint32_t step = 0; step < r.count; ++step) {
        if (step > 0 && (r.flags & hold_forces)) {
          a->netForce = vector_of(r.A.net_force);
          a->netTorque = vector_of(r.A.net_torque);
        }
        status = call_update(*a, r.h, 0);
      }
      break;
    case Function::friction_tangent:
    case Function::plane_response: {
      CollisionPlane plane(point_of(r.plane_point), vector_of(r.plane_normal));
      V3D tangent;
      if (function == Function::friction_tangent || (r.flags & want_helpers)) {
        status = call_tangent(plane, *a, at, tangent, 0);
        get(tangent, reply.vector);
      }
      if (function == Function::plane_response) status = call_plane(plane, *a, 0);
      break;
    }
    case Function::pair_response: {
      static ParticleSystem* const system = new ParticleSystem(&material);
      const std::unique_ptr<Cuboid> b = body_of(r, r.B);
      if (r.flags & want_helpers) ask_helpers(*b, reply.B_helpers);
      status = call_pair(*system, *a, *b, at, vector, 0);
      record(r.B, *b, reply.B);
      break;
    }
    default:
      break;
  }
  record(r.A, *a, reply.A);
  return status;
}

Status guarded(const Request& r) {
  try {
    return answer(r);
  } catch (const std::bad_alloc&) {
    return Status::out_of_memory;
  } catch (const std::exception& e) {
    std::snprintf(reply.text, sizeof reply.text, "%s", e.what());
  } catch (...) {
  }
  return Status::threw;
}

}  // namespace

#if defined(__SANITIZE_ADDRESS__)
// Built for advice: the sanitizers say where it went wrong themselves.
extern "C" const char* __asan_default_options() { return "detect_leaks=0:disable_coredump=0:color=never:max_allocation_size_mb=1024:allocator_may_return_null=1"; }
extern "C" const char* __ubsan_default_options() { return "print_stacktrace=1:color=never"; }
#endif

int main() {
#if !defined(__SANITIZE_ADDRESS__)
  listen_for_crashes();
#endif
  reply.magic = reply_magic;  // serial 0: the static constructors are done
  if (!write_whole(replies, &reply, sizeof reply)) _exit(0);
  for (Request r; read_whole(requests, &r, sizeof r);) {
    reply = Reply();
    reply.magic = reply_magic;
    reply.serial = r.serial;
    fesetenv(FE_DFL_ENV);
    reply.status = std::uint32_t(guarded(r));
    std::fflush(stdout);
    std::cout.flush();
    if (!write_whole(replies, &reply, sizeof reply)) break;
  }
  _exit(0);
}
