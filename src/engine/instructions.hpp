#pragma once
#include <vector>

namespace rigor {

/// The instructions a batch works with. The bits are the same with each.
enum class Instructions { baseline, avx2, avx512 };

const char* name(Instructions instructions);
/// Those this processor has, the widest last; never empty.
std::vector<Instructions> supported_instructions();
/// The widest of them.
Instructions widest_instructions();

}  // namespace rigor
