#include <rigor/engine/instructions.hpp>

namespace rigor {

const char* name(Instructions instructions) {
  constexpr const char* names[] = {"baseline", "avx2", "avx512"};
  return names[int(instructions)];
}

std::vector<Instructions> instructions_of(const ProcessorFlags& has) {
  std::vector<Instructions> found{Instructions::baseline};
  if (!(has.avx2 && has.fma)) return found;
  found.push_back(Instructions::avx2);
  if (has.avx512f && has.avx512dq && has.avx512vl) found.push_back(Instructions::avx512);
  return found;
}

std::vector<Instructions> supported_instructions() {
#ifdef __x86_64__
  return instructions_of({bool(__builtin_cpu_supports("avx2")), bool(__builtin_cpu_supports("fma")), bool(__builtin_cpu_supports("avx512f")),
                          bool(__builtin_cpu_supports("avx512dq")), bool(__builtin_cpu_supports("avx512vl"))});
#else
  return instructions_of({});
#endif
}

Instructions widest_instructions() {
  static const Instructions found = supported_instructions().back();
  return found;
}

}  // namespace rigor
