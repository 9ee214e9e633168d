#pragma once
#include <vector>

/// A row of the terse prototype: n equal steps (or evaluations) over T from the identity, moments I, spin w in body axes; R by rows.
struct PrototypeRow {
  const char* name;
  void (*fly)(const double I[3], const double w[3], double T, int n, double R[9]);
};
/// The same source under the flags of this project, and under its own (-O3 -march=native, FMA and AVX).
std::vector<PrototypeRow> rows_with_our_flags();
std::vector<PrototypeRow> rows_with_their_flags();
