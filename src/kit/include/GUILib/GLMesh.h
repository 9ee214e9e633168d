#pragma once
// Headless stand-in: a mesh keeps nothing and draws nothing.
#include <GL/glew.h>

#include <string>
#include <vector>

#include "MathLib/P3D.h"
#include "MathLib/V3D.h"

class GLShaderProgram {};

class GLShaderMaterial {
 public:
  template <class... Anything>
  void setFloatParam(Anything&&...) {}
  template <class... Anything>
  void setTextureParam(Anything&&...) {}
  template <class... Anything>
  void setShaderProgram(Anything&&...) {}
};

class GLMesh {
 public:
  GLShaderMaterial material;

  void addVertex(P3D) {}
  template <class Polygon>
  void addPoly(const Polygon&) {}
  void addPrism(const std::vector<P3D>&, const std::vector<P3D>&) {}
  void clear() {}
  void computeNormals() {}
  void setMaterial(const GLShaderMaterial&) {}
  void setMaterial(const GLShaderMaterial*) {}
  template <class... Anything>
  void setColour(Anything&&...) {}
  void drawMesh() {}
  void drawNormals() {}
};
