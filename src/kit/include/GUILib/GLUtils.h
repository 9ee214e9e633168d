#pragma once
// Headless stand-in: the drawing helpers of the window program.
#include <GL/glew.h>

#include "GUILib/GLMesh.h"

RIGOR_DRAWS_NOTHING(drawArrow)
RIGOR_DRAWS_NOTHING(drawBox)
RIGOR_DRAWS_NOTHING(drawCapsule)
RIGOR_DRAWS_NOTHING(drawCylinder)
RIGOR_DRAWS_NOTHING(drawSphere)
