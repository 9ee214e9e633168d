#pragma once
#include <Eigen/Core>
#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// What one run of a formula did: its operations in order, and the answers its comparisons were given.
///
/// A comparison of symbols has no answer of its own. The run is told one by the script; beyond the script it
/// stops with Undecided. Whoever records starts again with "yes" and with "no" appended, and so gets every path
/// the formula has, as a tree (write_tree in proofs/coq/trace.cpp). A loop whose end depends on the data has no
/// finite tree: std::logic_error after 64 comparisons.
class Recording {
 public:
  struct Undecided {
    std::string condition;  ///< a decidable proposition of Coq's reals: "Rlt_dec t3 t7"
  };

  explicit Recording(std::vector<bool> script) : script_(std::move(script)) {}

  std::string add(const std::string& operation) {
    operations_.push_back(operation);
    return "t" + std::to_string(operations_.size());
  }

  bool decide(const std::string& condition) {
    if (asked_ == 64) throw std::logic_error("Recording: more than 64 comparisons on one path");
    if (asked_ == script_.size()) throw Undecided{condition};
    begin_ = operations_.size();
    return script_[asked_++];
  }

  /// Operations from the last answered comparison on, as Coq's "let t3 := t1 + t2 in".
  std::string lets(const std::string& indent) const {
    std::string text;
    for (std::size_t i = begin_; i < operations_.size(); ++i)
      text += indent + "let t" + std::to_string(i + 1) + " := " + operations_[i] + " in\n";
    return text;
  }

 private:
  std::vector<bool> script_;
  std::vector<std::string> operations_;
  std::size_t asked_ = 0, begin_ = 0;
};

/// A scalar that writes down what is done to it, as terms over Coq's reals.
///
/// The templates of src/formulas run with it unchanged; proofs/coq/Bridge.v proves each recording equal to the
/// formula the theorems are about. It is trusted code, kept short, and guarded by the planted mistakes of
/// `proofs/check --mutants`. Constants belong to no recording and are written in place.
class Traced {
 public:
  Traced() : Traced(0) {}
  explicit Traced(int i) : term_(i < 0 ? "(" + std::to_string(i) + ")" : std::to_string(i)) {}
  template <std::floating_point F>
  Traced(F) = delete;
  Traced(Recording* in, std::string term) : in_(in), term_(std::move(term)) {}

  const std::string& term() const { return term_; }

  friend Traced operator+(const Traced& a, const Traced& b) { return write(a, b, a.term_ + " + " + b.term_); }
  friend Traced operator-(const Traced& a, const Traced& b) { return write(a, b, a.term_ + " - " + b.term_); }
  friend Traced operator*(const Traced& a, const Traced& b) { return write(a, b, a.term_ + " * " + b.term_); }
  friend Traced operator/(const Traced& a, const Traced& b) { return write(a, b, a.term_ + " / " + b.term_); }
  friend Traced operator-(const Traced& a) { return write(a, a, "- " + a.term_); }
  friend Traced sqrt(const Traced& a) { return write(a, a, "sqrt " + a.term_); }
  friend Traced abs(const Traced& a) { return write(a, a, "Rabs " + a.term_); }
  friend Traced sin(const Traced& a) { return write(a, a, "sin " + a.term_); }
  friend Traced cos(const Traced& a) { return write(a, a, "cos " + a.term_); }
  Traced& operator+=(const Traced& o) { return *this = *this + o; }
  Traced& operator-=(const Traced& o) { return *this = *this - o; }
  Traced& operator*=(const Traced& o) { return *this = *this * o; }
  Traced& operator/=(const Traced& o) { return *this = *this / o; }

  friend bool operator<(const Traced& a, const Traced& b) { return decide(a, b, "Rlt_dec"); }
  friend bool operator>(const Traced& a, const Traced& b) { return decide(a, b, "Rgt_dec"); }
  friend bool operator<=(const Traced& a, const Traced& b) { return decide(a, b, "Rle_dec"); }
  friend bool operator>=(const Traced& a, const Traced& b) { return decide(a, b, "Rge_dec"); }
  friend bool operator==(const Traced& a, const Traced& b) { return decide(a, b, "Req_EM_T"); }
  friend bool operator!=(const Traced& a, const Traced& b) { return !(a == b); }

 private:
  static Traced write(const Traced& a, const Traced& b, const std::string& operation) {
    Recording* in = a.in_ ? a.in_ : b.in_;
    return in ? Traced(in, in->add(operation)) : Traced(nullptr, "(" + operation + ")");
  }
  static bool decide(const Traced& a, const Traced& b, const std::string& how) {
    Recording* in = a.in_ ? a.in_ : b.in_;
    if (!in) throw std::logic_error("Traced: two constants compared");
    return in->decide(how + " " + a.term_ + " " + b.term_);
  }

  Recording* in_ = nullptr;
  std::string term_;
};

}  // namespace rigor

template <>
struct Eigen::NumTraits<rigor::Traced> : Eigen::GenericNumTraits<rigor::Traced> {
  using Real = rigor::Traced;
  using NonInteger = rigor::Traced;
  using Nested = rigor::Traced;
  using Literal = rigor::Traced;
  enum {
    IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 1, AddCost = 1, MulCost = 1
  };
  static Real epsilon() { return {nullptr, "eps"}; }  ///< a symbol: the bridges hold for every eps >= 0
};
