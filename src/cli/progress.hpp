#pragma once
#include <chrono>
#include <cstdio>
#include <string>

namespace rigor::cli {

/// "[#####.....] 12 of 100, 1:20 left" on stderr, overwritten in place; nothing where it is not `shown`.
class Progress {
 public:
  explicit Progress(bool shown) : shown_(shown) {}
  void operator()(int done, int all) const {
    if (!shown_) return;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const int left = int(spent / done * (all - done));
    std::string bar(30, '.');
    bar.replace(0, std::size_t(30 * done / all), std::size_t(30 * done / all), '#');
    std::fprintf(stderr, "\r[%s] %d of %d, %d:%02d left ", bar.c_str(), done, all, left / 60, left % 60);
    if (done == all) std::fputc('\n', stderr);
  }

 private:
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rigor::cli
