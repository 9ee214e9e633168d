#pragma once
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace rigor::cli {

/// "12 of 100, 1:20 left" of work in `all` parts, or the empty line before it takes two seconds in all.
inline std::string progress_words(long done, long all, double spent_s, const char* unit = "") {
  if (done <= 0 || spent_s / double(done) * double(all) < 2) return "";
  const long left = long(spent_s / double(done) * double(all - done) + 0.5);
  char text[90];
  std::snprintf(text, sizeof text, "%ld of %ld%s, %ld:%02ld left", done, all, unit, left / 60, left % 60);
  return text;
}

/// The same behind a bar: "[#####.....] 12 of 100, 1:20 left".
inline std::string progress_line(long done, long all, double spent_s, const char* unit = "") {
  const std::string words = progress_words(done, all, spent_s, unit);
  if (words.empty()) return "";
  std::string bar(30, '.');
  bar.replace(0, std::size_t(30 * done / all), std::size_t(30 * done / all), '#');
  return "[" + bar + "] " + words;
}

/// Says on stderr how far the work is, where `shown`. On a terminal in one line, gone when the work is done, so that what is
/// printed then stands alone; elsewhere, in a log, in a plain line every half minute.
class Progress {
 public:
  explicit Progress(bool shown = true, const char* unit = "") : shown_(shown), unit_(unit) {}
  Progress(const Progress&) = default;  // before the first word, as std::function needs it
  ~Progress() { clear(); }

  void operator()(long done, long all) {
    if (!shown_ || done == last_) return;
    last_ = done;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!terminal_) {
      if (spent < said_ + 30 || done >= all) return;
      said_ = spent;
      std::fprintf(stderr, "%s\n", progress_words(done, all, spent, unit_).c_str());
      return;
    }
    const std::string line = progress_line(done, all, spent, unit_);
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
  bool shown_, written_ = false, terminal_ = isatty(STDERR_FILENO) != 0;
  const char* unit_;
  long last_ = 0;
  double said_ = 0;  // s after the start
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rigor::cli
