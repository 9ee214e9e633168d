#pragma once
#include <map>
#include <memory>
#include <rigor/contact/surface.hpp>
#include <rigor/bodies/plane.hpp>
#include <rigor/grader/worker.hpp>
#include <rigor/studies/problem.hpp>
#include <rigor/studies/timing.hpp>

namespace rigor::studies {

/// A student's `update` and plane response beside our methods: run in the grader's worker, in its sandbox. From one thread.
class Student {
 public:
  /// Builds the submission (a directory or an archive). Faults: those of opening and building it; unsupported, when it has
  /// no update that compiles.
  static Outcome<Student> make(const std::filesystem::path& path);

  const std::string& name() const { return name_; }      ///< "submission NAME HASH": its cells' method
  bool has_plane_response() const { return has_plane_; }

  struct Flown {
    State<double> end;
    Timing timing;   ///< on the wall, less that of a call that does nothing; processor times are those of the wall
  };
  /// `update(h)`, `steps` times in one call. Faults: unsupported, with the worker's words (a crash, no end), or a load that is
  /// neither zero nor constant.
  Outcome<Flown> fly(const Problem& problem, long steps, int repeats);

  /// A cuboid, a plane and gravity: plane response, then update, as the assignment's program does. `see` gets each state;
  /// it says when to stop. Faults: as above; unsupported where the submission fixes its own constants.
  Outcome<bool> bounce(const Cuboid<double>& body, const State<double>& start, const Plane<double>& plane, const Surface<double>& surface, const Vec3<double>& gravity, double h,
                       long steps, const std::function<bool(double t, const State<double>&)>& see);

 private:
  std::filesystem::path executable_;
  std::string name_;
  bool has_plane_ = false, own_constants_ = false;
};

}  // namespace rigor::studies
