#pragma once
// Headless stand-in: there is no window.
#include <GL/glew.h>

struct GLFWwindow;
inline double glfwGetTime() { return 0; }
RIGOR_DRAWS_NOTHING(glfwPollEvents)
RIGOR_DRAWS_NOTHING(glfwSwapBuffers)
