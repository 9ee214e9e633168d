# cmake -DOUT=x.cpp -DROOT=dir -DFILES=list -DLAYER=cli -P embed.cmake: the files as string literals in one source
# file, so that the installed program can explain itself, and compile submissions, without the source tree.
string(REPLACE "|" ";" FILES "${FILES}")
set(text "#include <rigor/${LAYER}/texts.hpp>\n\nnamespace rigor::${LAYER} {\n\nconst std::vector<Text>& texts() {\n  static const std::vector<Text> all{\n")
foreach(file IN LISTS FILES)
  file(READ "${file}" content)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  string(APPEND text "      {\"${name}\", R\"rigor-text(${content})rigor-text\"},\n")
endforeach()
string(APPEND text "  };\n  return all;\n}\n\n}  // namespace rigor::${LAYER}\n")
file(WRITE "${OUT}" "${text}")
