#pragma once
// Headless stand-in: every file is an empty mesh.
#include "GUILib/GLMesh.h"

class OBJReader {
 public:
  static GLMesh* loadOBJFile(const char*) { return new GLMesh(); }
};
