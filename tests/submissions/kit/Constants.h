#pragma once

const double COEFF_RESITUTION = 0.5;
const double COEFF_STATIC_FRICTION = 0.5;
const double COEFF_DYNAMIC_FRICTION = 0.3;
const double DELTA_T = 1.0 / 240;  // seconds
