// The course's constants, fixed for a process before any static constructor of the submission runs: four words of
// sixteen hexadecimal digits, the bits of the doubles, follow the program's name. C++14; no header, because to
// everybody else these are const.
double COEFF_RESITUTION = 0.5;
double COEFF_STATIC_FRICTION = 0.5;
double COEFF_DYNAMIC_FRICTION = 0.3;
double DELTA_T = 1.0 / 240;

namespace {

double from_bits(const char* digits) {
  unsigned long long bits = 0;
  for (; *digits; ++digits) bits = bits << 4 | unsigned(*digits <= '9' ? *digits - '0' : *digits - 'a' + 10);
  double value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

void set_constants(int argc, char** argv, char**) {
  if (argc < 5) return;
  COEFF_RESITUTION = from_bits(argv[1]);
  COEFF_STATIC_FRICTION = from_bits(argv[2]);
  COEFF_DYNAMIC_FRICTION = from_bits(argv[3]);
  DELTA_T = from_bits(argv[4]);
}

using Preinit = void (*)(int, char**, char**);
__attribute__((section(".preinit_array"), used)) Preinit before_constructors = set_constants;

}  // namespace
