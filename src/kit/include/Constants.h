#pragma once
// The grader's own Constants.h: the values are set for each process before anything else of it runs.
extern const double COEFF_RESITUTION;
extern const double COEFF_STATIC_FRICTION;
extern const double COEFF_DYNAMIC_FRICTION;
extern const double DELTA_T;
