#pragma once
#include <cmath>
#include <utility>
#include <vector>

namespace rigor::reference {

/// A truncated Taylor series a₀ + a₁ h + a₂ h² + ...: arithmetic on it differentiates whatever is written with it, to any
/// order. A constant is a series of one term; the terms that are not there are zero, and operations keep the longer length.
template <class T>
class Jet {
 public:
  Jet(const T& constant) : a_{constant} {}
  explicit Jet(std::vector<T> terms) : a_(std::move(terms)) {}

  std::size_t size() const { return a_.size(); }
  T operator[](std::size_t k) const { return k < a_.size() ? a_[k] : T(0); }

  friend Jet operator+(const Jet& x, const Jet& y) {
    return made(longer(x, y), [&](std::size_t k, const auto&) { return T(x[k] + y[k]); });
  }
  friend Jet operator-(const Jet& x, const Jet& y) {
    return made(longer(x, y), [&](std::size_t k, const auto&) { return T(x[k] - y[k]); });
  }
  friend Jet operator-(const Jet& x) { return Jet(T(0)) - x; }
  friend Jet operator*(const Jet& x, const Jet& y) {
    return made(longer(x, y), [&](std::size_t k, const auto&) {
      T sum = T(0);
      for (std::size_t j = 0; j <= k; ++j)
        if (j < x.size() && k - j < y.size()) sum += x.a_[j] * y.a_[k - j];
      return sum;
    });
  }
  friend Jet operator/(const Jet& x, const Jet& y) {  // q y = x
    return made(longer(x, y), [&](std::size_t k, const std::vector<T>& q) {
      T sum = x[k];
      for (std::size_t j = 0; j < k; ++j) sum -= q[j] * y[k - j];
      return T(sum / y.a_[0]);
    });
  }
  friend Jet sqrt(const Jet& x) {  // r r = x
    using std::sqrt;
    return made(x.size(), [&](std::size_t k, const std::vector<T>& r) {
      if (k == 0) return T(sqrt(x.a_[0]));
      T sum = x[k];
      for (std::size_t j = 1; j < k; ++j) sum -= r[j] * r[k - j];
      return T(sum / (T(2) * r[0]));
    });
  }
  friend Jet exp(const Jet& x) {  // e' = x' e
    using std::exp;
    return made(x.size(), [&](std::size_t k, const std::vector<T>& e) {
      if (k == 0) return T(exp(x.a_[0]));
      T sum = T(0);
      for (std::size_t j = 1; j <= k; ++j) sum += T(int(j)) * x[j] * e[k - j];
      return T(sum / T(int(k)));
    });
  }
  /// Both at once: s' = x' c, c' = −x' s.
  friend std::pair<Jet, Jet> sin_cos(const Jet& x) {
    using std::cos, std::sin;
    std::vector<T> s{T(sin(x.a_[0]))}, c{T(cos(x.a_[0]))};
    for (std::size_t k = 1; k < x.size(); ++k) {
      T up = T(0), down = T(0);
      for (std::size_t j = 1; j <= k; ++j) up += T(int(j)) * x[j] * c[k - j], down -= T(int(j)) * x[j] * s[k - j];
      s.push_back(up / T(int(k)));
      c.push_back(down / T(int(k)));
    }
    return {Jet(std::move(s)), Jet(std::move(c))};
  }
  friend Jet sin(const Jet& x) { return sin_cos(x).first; }
  friend Jet cos(const Jet& x) { return sin_cos(x).second; }

 private:
  static std::size_t longer(const Jet& x, const Jet& y) { return x.size() > y.size() ? x.size() : y.size(); }
  template <class Term>
  static Jet made(std::size_t n, Term term) {  // each term may use those before it
    std::vector<T> a;
    a.reserve(n);
    for (std::size_t k = 0; k < n; ++k) a.push_back(term(k, a));
    return Jet(std::move(a));
  }
  std::vector<T> a_;
};

/// y' = f(t, y) by its Taylor series: `order` terms a step, `steps` equal steps. f is written once for Jets:
/// std::vector<Jet<T>> f(const Jet<T>& t, const std::vector<Jet<T>>& y), out of + − × ÷, sqrt, exp, sin, cos. The k-th term of y
/// gives the k-th of y', which is (k + 1) times the next of y. Costs order³ multiplications a step: for references only.
/// errors    (h/r)^order a step, r the distance of the nearest singularity in the complex plane of t
template <class T, class F>
std::vector<T> taylor(const F& f, std::vector<T> y, const T& t0, const T& t1, int order, int steps) {
  const T h = (t1 - t0) / T(steps);
  for (int n = 0; n < steps; ++n) {
    std::vector<std::vector<T>> terms;
    for (const T& value : y) terms.push_back({value});
    for (int k = 0; k < order; ++k) {
      std::vector<Jet<T>> now;
      for (const auto& a : terms) now.push_back(Jet<T>(a));
      std::vector<T> time(std::size_t(k + 1), T(0));
      time[0] = t0 + T(n) * h;
      if (k > 0) time[1] = T(1);
      const std::vector<Jet<T>> rate = f(Jet<T>(std::move(time)), now);
      for (std::size_t i = 0; i < y.size(); ++i) terms[i].push_back(rate[i][std::size_t(k)] / T(k + 1));
    }
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = terms[i].back();
      for (std::size_t k = terms[i].size() - 1; k-- > 0;) y[i] = y[i] * h + terms[i][k];
    }
  }
  return y;
}

}  // namespace rigor::reference
