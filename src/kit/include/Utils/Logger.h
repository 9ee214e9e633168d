#pragma once

// Headless stand-in: what is logged goes nowhere. Print to std::cerr to see it in the report.
class Logger {
 public:
  template <class... Anything>
  static void consolePrint(const char*, Anything&&...) {}
  template <class... Anything>
  static void print(const char*, Anything&&...) {}
  template <class... Anything>
  static void logPrint(const char*, Anything&&...) {}
};
