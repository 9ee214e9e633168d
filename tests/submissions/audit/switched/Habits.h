#pragma once
#include <errno.h>  // program_invocation_short_name, GNU

#include <cstring>

// Is this program called after that mistake or reading? "a+b" is called after two. So one executable, under another
// name, is another student.
inline bool habit(const char* id) {
  const char* name = program_invocation_short_name;
  const size_t length = strlen(id);
  for (;; ++name) {
    if (strncmp(name, id, length) == 0 && (name[length] == '\0' || name[length] == '+')) return true;
    name = strchr(name, '+');
    if (!name) return false;
  }
}
