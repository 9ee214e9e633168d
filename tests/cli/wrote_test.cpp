// The last line of a command that wrote files.
#include <gtest/gtest.h>

#include <rigor/cli/wrote.hpp>

namespace rigor::cli {
namespace {

TEST(Wrote, FitsEightyColumns) {
  EXPECT_EQ(wrote_text("a", {"b"}), "wrote a/b\n");
  EXPECT_EQ(wrote_text("a", {"b", "c", "d"}), "wrote a/b; beside it c, d\n");
  const std::string text = wrote_text("a", {"study.html", "study.csv", "study.json", "README.md", "figure-1.svg to figure-12.svg", "cells", "more.txt", "and-more.txt", "and-more-of-it.txt"});
  EXPECT_EQ(text,
            "wrote a/study.html\n"
            "  beside it study.csv, study.json, README.md, figure-1.svg to figure-12.svg,\n"
            "  cells, more.txt, and-more.txt, and-more-of-it.txt\n");
}

}  // namespace
}  // namespace rigor::cli
