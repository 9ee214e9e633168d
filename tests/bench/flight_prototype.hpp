#pragma once

// What flight_ratio_bench.cpp asks of the prototype, whose flags and headers it must not share. Flights start at R = 1.
extern "C" {
using PrototypeSetUp = void(const double* I_B, const double* w_B, bool extended, long times);
using PrototypeFlight = void*(const double* I_B, const double* w_B);  // extended constants
/// `times` evaluations at t, t + dt ...; the last attitude.
using PrototypeEvaluate = void(const void* flight, double t, double dt, long times, double* R_by_rows);
/// All of m ≤ 1/2; null where one is not.
using PrototypeFlights = void*(long count, const double* I_B, const double* w_B);
using PrototypeEvaluateAll = void(void* flights, double t);
}
