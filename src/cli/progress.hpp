#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace rigor::cli {

/// "[#####.....] 12 of 100, 1:20 left" of work in `all` parts, or the empty line before it takes two seconds in all.
inline std::string progress_line(long done, long all, double spent_s, const char* unit = "") {
  if (done <= 0 || spent_s / double(done) * double(all) < 2) return "";
  const long left = long(spent_s / double(done) * double(all - done) + 0.5);
  std::string bar(30, '.');
  bar.replace(0, std::size_t(30 * done / all), std::size_t(30 * done / all), '#');
  char text[120];
  std::snprintf(text, sizeof text, "[%s] %ld of %ld%s, %ld:%02ld left", bar.c_str(), done, all, unit, left / 60, left % 60);
  return text;
}

/// Says on stderr how far the work is, where that is a terminal and `shown`. Its line is gone when the work is done, so
/// that what is printed then stands alone.
class Progress {
 public:
  explicit Progress(bool shown = true, const char* unit = "") : shown_(shown && isatty(STDERR_FILENO) != 0), unit_(unit) {}
  Progress(const Progress&) = default;  // before the first word, as std::function needs it
  ~Progress() { clear(); }

  void operator()(long done, long all) {
    if (!shown_ || done == last_) return;
    last_ = done;
    const std::string line = progress_line(done, all, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(), unit_);
    if (line.empty()) return;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    written_ = true;
    if (done >= all) clear();
  }
  void clear() {
    if (written_) std::fputs("\r\033[K", stderr);
    written_ = false;
  }

 private:
  bool shown_, written_ = false;
  const char* unit_;
  long last_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rigor::cli
