#pragma once
#include <vector>

namespace rigor {

/// The instructions a batch works with. The bits are the same with each.
enum class Instructions { baseline, avx2, avx512 };

const char* name(Instructions instructions);

/// What a processor says it has; each may be there without the others (a guest's may be masked).
struct ProcessorFlags {
  bool avx2 = false, fma = false, avx512f = false, avx512dq = false, avx512vl = false;
};
/// Those a processor with these flags has: avx2 asks for avx2 and fma, avx512 for all five; the widest last, never empty.
std::vector<Instructions> instructions_of(const ProcessorFlags& has);
/// Those this processor has, the widest last; never empty.
std::vector<Instructions> supported_instructions();
/// The widest of them.
Instructions widest_instructions();

}  // namespace rigor
