#pragma once
#include <array>
#include <rigor/linalg/types.hpp>

namespace rigor {

/// A planar impact: effective inverse masses in the plane of n and t, and the relative velocity before.
template <Field T>
struct PlanarImpact {
  T k_nn, k_tt, k_tn;  ///< 1/kg; k_nn k_tt > k_tn²
  T v_n, v_t;          ///< m/s; v_n < 0 approaches, v_t ≥ 0 (t points along the slip)
  T e, mu_s, mu_d;     ///< 0 ≤ e ≤ 1, 0 ≤ μ_d ≤ μ_s
};

enum class PlanarMode { sliding, sticking, reversed };

template <Field T>
struct PlanarImpulse {
  T j_n, j_t;       ///< N·s on B; j_t along t
  PlanarMode mode;  ///< of the last moment of the impact
};

/// When an impact ends, once compression has: by energy, by impulse, or by velocity.
enum class Restitution { stronge, poisson, newton };

namespace detail {

/// One leg of Routh's process: the impulse p = j_n grows, everything else is linear in it.
template <Field T>
struct RouthLeg {
  T dj_t, dv_n;  // per unit of p
  PlanarMode mode;
};

/// What follows once the slip has stopped: stick if static friction can hold it, else slip the other way.
template <Field T>
RouthLeg<T> leg_without_slip(const PlanarImpact<T>& impact) {
  const T pull = impact.k_tn < T(0) ? -impact.k_tn : impact.k_tn;
  if (pull <= impact.mu_s * impact.k_tt) {
    const T hold = -impact.k_tn / impact.k_tt;
    return {hold, impact.k_nn + hold * impact.k_tn, PlanarMode::sticking};
  }
  const T friction = impact.k_tn < T(0) ? impact.mu_d : -impact.mu_d;
  return {friction, impact.k_nn + friction * impact.k_tn,
          impact.k_tn < T(0) ? PlanarMode::reversed : PlanarMode::sliding};
}

}  // namespace detail

/// Planar impact with friction by Routh's method: contact forces act in a process whose clock is the normal impulse
/// p; slip may stop, stick or reverse inside it. The end of restitution is where
///
///     stronge:  ∫ v_n dp (restitution) = −e² ∫ v_n dp (compression)     poisson:  p_f = (1+e) p_c     newton:  v_n' = −e v_n
///
/// Stronge's never adds energy. In every leg v_n is linear in p, so the process is two legs and one root. A leg on
/// which v_n falls (jam) ends by itself: friction stops the slip, and the next leg's slope is positive.
///
/// shapes    PlanarImpact → PlanarImpulse
/// units     N·s
/// frames    n from A to B; impulse on B
/// scalars   Field for poisson and newton, exact over ℚ; Rooted for stronge
/// domain    as stated in PlanarImpact
/// rounding  within 32 u of |j| times k_nn k_tt/(k_nn k_tt − k_tn²); over half of that was seen (tests/rounding)
/// id        friction.stronge_planar
/// source    Routh; Wang and Mason 1992; Stronge 1990; derivation in proofs/friction.md
template <Rooted T>
PlanarImpulse<T> planar_impulse(const PlanarImpact<T>& impact, Restitution rule) {
  using std::sqrt;
  // the first leg slips along +t, until p_stop or for good
  std::array<detail::RouthLeg<T>, 2> leg{
      detail::RouthLeg<T>{-impact.mu_d, impact.k_nn - impact.mu_d * impact.k_tn, PlanarMode::sliding},
      detail::leg_without_slip<T>(impact)};
  const T slip_rate = impact.k_tn - impact.mu_d * impact.k_tt;
  const bool slips = impact.v_t > T(0), stops = slips && slip_rate < T(0);
  if (!slips) leg[0] = leg[1];
  const T p_stop = stops ? -impact.v_t / slip_rate : T(0);
  const T v_stop = impact.v_n + leg[0].dv_n * p_stop;  // v_n when the slip stops

  // compression: v_n reaches 0 on the first leg, or on the second
  const bool compressed_early = !stops || v_stop >= T(0);
  const T p_c = compressed_early ? -impact.v_n / leg[0].dv_n : p_stop - v_stop / leg[1].dv_n;
  const T work_c = compressed_early ? impact.v_n * p_c / T(2)
                                    : (impact.v_n + v_stop) * p_stop / T(2) + v_stop * (p_c - p_stop) / T(2);
  // restitution may still cross from the first leg to the second
  const bool crosses = stops && compressed_early;
  const auto& last = compressed_early && !crosses ? leg[0] : leg[1];

  T p_f;
  bool on_first = false;
  if (rule == Restitution::poisson) {
    p_f = (T(1) + impact.e) * p_c;
    on_first = crosses && p_f <= p_stop;
  } else if (rule == Restitution::newton) {
    const T v_end = -impact.e * impact.v_n;
    on_first = crosses && v_end <= v_stop;
    p_f = on_first ? p_c + v_end / leg[0].dv_n : crosses ? p_stop + (v_end - v_stop) / last.dv_n : p_c + v_end / last.dv_n;
  } else {
    const T work = -impact.e * impact.e * work_c;  // > 0
    const T work_to_stop = crosses ? v_stop * (p_stop - p_c) / T(2) : T(0);
    on_first = crosses && work <= work_to_stop;
    if (on_first) p_f = p_c + sqrt(T(2) * work / leg[0].dv_n);
    else if (crosses) p_f = p_stop + (sqrt(v_stop * v_stop + T(2) * last.dv_n * (work - work_to_stop)) - v_stop) / last.dv_n;
    else p_f = p_c + sqrt(T(2) * work / last.dv_n);
  }
  if (!stops || on_first) return {p_f, leg[0].dj_t * p_f, leg[0].mode};
  return {p_f, leg[0].dj_t * p_stop + leg[1].dj_t * (p_f - p_stop), leg[1].mode};
}

}  // namespace rigor
