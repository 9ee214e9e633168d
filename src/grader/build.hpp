#pragma once
#include <array>
#include <filesystem>
#include <rigor/base/outcome.hpp>
#include <rigor/grader/submission.hpp>
#include <set>
#include <string>
#include <vector>

namespace rigor::grader {

/// The functions a student writes, in the order of the assignment.
enum class StudentFunction {
  body_inertia,           // Cuboid::computeBodyCoordsMOI
  world_inertia,          // Cuboid::computeWorldCoordsMOI
  world_inverse_inertia,  // Cuboid::computeWorldCoordsInverseMOI
  apply_force,            // Cuboid::applyForce
  update,                 // Cuboid::update
  friction_tangent,       // CollisionPlane::frictionTangent
  plane_response,         // CollisionPlane::applyCollisionResponse
  pair_response,          // ParticleSystem::applyCollisionImpulse
};
inline constexpr std::size_t student_functions = 8;

/// "Cuboid::update" and so on.
const char* student_function_name(StudentFunction function);

/// What became of one of them.
struct FunctionStatus {
  enum class Kind {
    compiled,
    not_compiled,     ///< its body was replaced by the handed-out one; `error` says why
    not_implemented,  ///< as handed out, or not there at all
  };
  Kind kind = Kind::compiled;
  std::string error;  ///< the compiler's first error in it, clipped, with file and line as the student knows them
};

struct BuildOptions {
  std::filesystem::path cache{};  ///< objects and precompiled headers by content; empty: `default_cache()`
  int jobs = 1;                 ///< compilers at a time
  bool sanitize = false;        ///< address and undefined-behaviour sanitizers: advice, not for grading
  /// Functions to be replaced by the handed-out ones although they compile: a function every other one runs
  /// through (body_inertia, in the constructor) and that crashes or hangs need not cost the rest.
  std::set<StudentFunction> replaced{};
};

/// $RIGOR_CACHE, else /var/cache/rigor for root, else $XDG_CACHE_HOME/rigor or ~/.cache/rigor.
std::filesystem::path default_cache();

/// Of the handed-out files, the headers and the driver every submission is compiled with.
std::string kit_hash();
/// Of the program that runs: another build of the tool has another.
std::string tool_hash();

/// A submission compiled against the kit and the driver. The executable lies in the cache and stays valid.
struct BuildResult {
  std::filesystem::path executable;  ///< empty when nothing could be built: `notes` say why
  std::array<FunctionStatus, student_functions> functions;
  bool own_constants = false;           ///< brings its own Constants.h: ask the worker (Function::constants)
  std::vector<std::string> notes;       ///< for the student: what was replaced, missing, renamed
  std::vector<std::string> isolation;   ///< the layers the compiler ran under, one line each
  int compiled = 0, reused = 0;         ///< objects
  double seconds = 0;

  const FunctionStatus& of(StudentFunction f) const { return functions[std::size_t(f)]; }
};

/// Compiles each file on its own inside the sandbox. A function that does not compile costs only itself.
/// Never fails for what the submission contains; promises hold for everything else. Faults: unwritable (cache),
/// unsupported (no compiler, no Eigen, interrupted).
Outcome<BuildResult> build(const Submission& submission, const BuildOptions& options = {});

}  // namespace rigor::grader
