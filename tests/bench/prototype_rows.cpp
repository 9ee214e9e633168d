// Compiled by tests/bench/prototype, once for each name of PROTOTYPE_ROWS, with the prototype's directory among the includes.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tests/bench/prototype_rows.hpp>

namespace PROTOTYPE_ROWS_SPACE {
#include <fast.hpp>
#include <methods.hpp>

Body body(const double I[3]) { return {{I[0], I[1], I[2]}, {1 / I[0], 1 / I[1], 1 / I[2]}}; }
void put(const Out& o, double R[9]) {
  for (int i = 0; i < 9; ++i) R[i] = o.R.a[i / 3][i % 3];
}
template <auto F>
void fly(const double I[3], const double w[3], double T, int n, double R[9]) {
  put(F(body(I), V3{w[0], w[1], w[2]}, T, n), R);
}
template <int k>
Out three(const Body& b, V3 w, double T, int n) { return split3(b, w, T, n, comps[k]); }
template <int k>
Out two(const Body& b, V3 w, double T, int n) { return split2(b, w, T, n, comps[k]); }
template <int order>
Out veselov(const Body& b, V3 w, double T, int n) { return dmv(b, w, T, n, order); }
Out buss(const Body& b, V3 w, double T, int n) { return buss2(b, w, T, n, false); }

frb::Fast prepared(const double I[3], const double w[3]) {
  const long double extended_I[3] = {I[0], I[1], I[2]}, extended_w[3] = {w[0], w[1], w[2]}, one[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return frb::makeFast(frb::setup<long double>(extended_I, extended_w, one));
}
void evaluate(const frb::Fast& f, double t, double R[9]) {
  double A[3][3], L[3];
  frb::evalFast<false>(f, t, A, L);
  for (int i = 0; i < 9; ++i) R[i] = A[i / 3][i % 3];
  asm volatile("" : : "r"(L) : "memory");
}
void evaluations(const double I[3], const double w[3], double T, int n, double R[9]) {
  const frb::Fast f = prepared(I, w);
  for (int k = 1; k <= n; ++k) evaluate(f, T * k / n, R);
}
void flights(const double I[3], const double w[3], double T, int n, double R[9]) {
  for (int k = 1; k <= n; ++k) evaluate(prepared(I, w), T, R);
}

}  // namespace PROTOTYPE_ROWS_SPACE

std::vector<PrototypeRow> PROTOTYPE_ROWS() {
  using namespace PROTOTYPE_ROWS_SPACE;
  return {{"symEuler+GS", fly<symEulerGS>}, {"Euler-exp", fly<eulerExp>},          {"impl-midpoint-Lie", fly<implMid>}, {"buss-aug2", fly<buss>},
          {"RK4-quat", fly<rk4q>},          {"RKMK4", fly<rkmk4>},                 {"CF4", fly<cf4>},                   {"split3-Strang", fly<three<0>>},
          {"split3-Yoshida4", fly<three<1>>}, {"split2-Strang", fly<two<0>>},      {"split2-Yoshida4", fly<two<1>>},    {"split2-KahanLi6", fly<two<4>>},
          {"split2-KahanLi8", fly<two<5>>}, {"DMV2", fly<veselov<2>>},             {"DMV4", fly<veselov<4>>},           {"DMV8", fly<veselov<8>>},
          {"Taylor16", fly<taylorD<16>>},   {"tuned-ld-eval", evaluations},        {"tuned-ld-setup+eval", flights}};
}
