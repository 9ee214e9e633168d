#pragma once
#include <string>
#include <utility>
#include <variant>

namespace rigor {

/// What was wrong with a value that came from outside (a file, a command line, a submission).
///
/// `where` names the file and field ("scene.json: cuboids[2].mass"), `what` the value found and the range
/// allowed ("is -1, must be > 0"). Printed as one line: "where what".
struct Fault {
  enum class Kind {
    not_finite,
    not_positive,
    negative,
    out_of_range,
    not_unit,
    not_orthonormal,
    unknown_key,
    missing,
    wrong_type,
    malformed,
    unreadable,
    unwritable,
    unsupported,
  };
  Kind kind;
  std::string where;
  std::string what;

  std::string text() const { return where.empty() ? what : where + " " + what; }
  /// The same fault seen from further out: Fault{"mass"} inside "cuboids[2]" is Fault{"cuboids[2].mass"}.
  Fault inside(const std::string& outer) const {
    const bool index = !where.empty() && where.front() == '[';
    return {kind, where.empty() ? outer : outer + (index ? "" : ".") + where, what};
  }
};

/// A value or the reason why there is none. Building from outside returns this; nothing else does.
template <class T>
class [[nodiscard]] Outcome {
 public:
  Outcome(T value) : held_(std::in_place_index<0>, std::move(value)) {}
  Outcome(Fault fault) : held_(std::in_place_index<1>, std::move(fault)) {}

  explicit operator bool() const { return held_.index() == 0; }
  /// Precondition: bool(*this). Throws std::bad_variant_access otherwise.
  const T& value() const& { return std::get<0>(held_); }
  T&& value() && { return std::get<0>(std::move(held_)); }
  const T& operator*() const& { return value(); }
  const T* operator->() const { return &value(); }
  /// Precondition: !bool(*this). Throws std::bad_variant_access otherwise.
  const Fault& fault() const { return std::get<1>(held_); }

 private:
  std::variant<T, Fault> held_;
};

}  // namespace rigor
