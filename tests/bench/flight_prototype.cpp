// The prototype of exact flight behind plain functions, for flight_ratio_bench.cpp: compiled by tests/bench/flight from the
// prototype's directory, with the flags its README gives.
#define main prototype_main
#include "soa.cpp"
#undef main

#include "flight_prototype.hpp"

namespace {

template <class T>
frb::Fast make(const double* I, const double* w) {
  const T moments[3] = {I[0], I[1], I[2]}, spin[3] = {w[0], w[1], w[2]}, R0[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return frb::makeFast(frb::setup<T>(moments, spin, R0));
}
void use(const void* value) { asm volatile("" : : "r"(value) : "memory"); }

template <class T>
void set_up(const double* I, const double* w, long times) {
  for (long k = 0; k < times; ++k) {
    use(I), use(w);
    const frb::Fast made = make<T>(I, w);
    use(&made);
  }
}

}  // namespace

extern "C" {

void prototype_set_up(const double* I, const double* w, bool extended, long times) { extended ? set_up<long double>(I, w, times) : set_up<double>(I, w, times); }

void* prototype_flight(const double* I, const double* w) { return new frb::Fast(make<long double>(I, w)); }

void prototype_evaluate(const void* flight, double t, double dt, long times, double* R_by_rows) {
  double R[3][3], L[3];
  for (long k = 0; k < times; ++k) {
    frb::evalFast<false>(*static_cast<const frb::Fast*>(flight), t, R, L);
    use(R), use(L);
    t += dt;
  }
  for (int k = 0; k < 9; ++k) R_by_rows[k] = R[k / 3][k % 3];
}

void* prototype_flights(long count, const double* I, const double* w) {
  EX* all = new EX(int(count));
  for (long i = 0; i < count; ++i) {
    const frb::Fast f = make<long double>(I + 3 * i, w + 3 * i);
    if (f.kind != 1) return nullptr;
    const double head[12] = {f.nuh, f.nul, f.n0, f.ah, f.al, f.rho, f.z3ct, f.L1st, f.sg[0] * f.L1m, f.sg[1] * f.L2m, f.sg[2] * f.L3m, 0};
    for (int k = 0; k < 12; ++k) all->c[std::size_t(k)][i] = head[k];
    const double* cubics[6] = {f.p4, f.p1, f.p2, f.p3, f.pa, f.pb};
    for (int c = 0; c < 6; ++c)
      for (int k = 0; k < 4; ++k) all->c[std::size_t(12 + 4 * c + k)][i] = cubics[c][k];
    for (int k = 0; k < 9; ++k) all->c[std::size_t(36 + k)][i] = f.C[k / 3][k % 3];
  }
  return all;
}
void prototype_evaluate_all(void* flights, double t) { exStep(*static_cast<EX*>(flights), t); }

}  // extern "C"
