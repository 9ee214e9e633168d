#include <rigor/engine/instructions.hpp>

namespace rigor {

const char* name(Instructions instructions) {
  constexpr const char* names[] = {"baseline", "avx2", "avx512"};
  return names[int(instructions)];
}

std::vector<Instructions> supported_instructions() {
  std::vector<Instructions> found{Instructions::baseline};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) found.push_back(Instructions::avx2);
  if (found.size() == 2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    found.push_back(Instructions::avx512);
#endif
  return found;
}

Instructions widest_instructions() {
  static const Instructions found = supported_instructions().back();
  return found;
}

}  // namespace rigor
