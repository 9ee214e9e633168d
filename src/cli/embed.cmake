# cmake -DOUT=x.cpp -DROOT=dir -DFILES=list -P embed.cmake: the files as string literals in one source file, so that
# the installed program can explain itself without the source tree.
string(REPLACE "|" ";" FILES "${FILES}")
set(text "#include <rigor/cli/texts.hpp>\n\nnamespace rigor::cli {\n\nconst std::vector<Text>& texts() {\n  static const std::vector<Text> all{\n")
foreach(file IN LISTS FILES)
  file(READ "${file}" content)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  string(APPEND text "      {\"${name}\", R\"rigor-text(${content})rigor-text\"},\n")
endforeach()
string(APPEND text "  };\n  return all;\n}\n\n}  // namespace rigor::cli\n")
file(WRITE "${OUT}" "${text}")
