#pragma once
// Headless stand-in for the drawing calls of a submission: every one compiles, none does anything.

typedef unsigned int GLenum;
typedef unsigned int GLuint;
typedef unsigned int GLbitfield;
typedef int GLint;
typedef int GLsizei;
typedef float GLfloat;
typedef double GLdouble;
typedef unsigned char GLubyte;
typedef unsigned char GLboolean;
typedef void GLvoid;

#define RIGOR_DRAWS_NOTHING(name) \
  template <class... Anything>    \
  inline void name(Anything&&...) {}

RIGOR_DRAWS_NOTHING(glBegin)
RIGOR_DRAWS_NOTHING(glBindTexture)
RIGOR_DRAWS_NOTHING(glBlendFunc)
RIGOR_DRAWS_NOTHING(glClear)
RIGOR_DRAWS_NOTHING(glClearColor)
RIGOR_DRAWS_NOTHING(glColor3d)
RIGOR_DRAWS_NOTHING(glColor3f)
RIGOR_DRAWS_NOTHING(glColor3fv)
RIGOR_DRAWS_NOTHING(glColor4d)
RIGOR_DRAWS_NOTHING(glColor4f)
RIGOR_DRAWS_NOTHING(glColor4fv)
RIGOR_DRAWS_NOTHING(glDisable)
RIGOR_DRAWS_NOTHING(glEnable)
RIGOR_DRAWS_NOTHING(glEnd)
RIGOR_DRAWS_NOTHING(glFlush)
RIGOR_DRAWS_NOTHING(glLightfv)
RIGOR_DRAWS_NOTHING(glLineWidth)
RIGOR_DRAWS_NOTHING(glLoadIdentity)
RIGOR_DRAWS_NOTHING(glLoadMatrixd)
RIGOR_DRAWS_NOTHING(glMaterialf)
RIGOR_DRAWS_NOTHING(glMaterialfv)
RIGOR_DRAWS_NOTHING(glMatrixMode)
RIGOR_DRAWS_NOTHING(glMultMatrixd)
RIGOR_DRAWS_NOTHING(glMultMatrixf)
RIGOR_DRAWS_NOTHING(glNormal3d)
RIGOR_DRAWS_NOTHING(glNormal3f)
RIGOR_DRAWS_NOTHING(glPointSize)
RIGOR_DRAWS_NOTHING(glPolygonMode)
RIGOR_DRAWS_NOTHING(glPopAttrib)
RIGOR_DRAWS_NOTHING(glPopMatrix)
RIGOR_DRAWS_NOTHING(glPushAttrib)
RIGOR_DRAWS_NOTHING(glPushMatrix)
RIGOR_DRAWS_NOTHING(glRotated)
RIGOR_DRAWS_NOTHING(glRotatef)
RIGOR_DRAWS_NOTHING(glScaled)
RIGOR_DRAWS_NOTHING(glScalef)
RIGOR_DRAWS_NOTHING(glShadeModel)
RIGOR_DRAWS_NOTHING(glTexCoord2d)
RIGOR_DRAWS_NOTHING(glTranslated)
RIGOR_DRAWS_NOTHING(glTranslatef)
RIGOR_DRAWS_NOTHING(glUseProgram)
RIGOR_DRAWS_NOTHING(glVertex2d)
RIGOR_DRAWS_NOTHING(glVertex3d)
RIGOR_DRAWS_NOTHING(glVertex3dv)
RIGOR_DRAWS_NOTHING(glVertex3f)
RIGOR_DRAWS_NOTHING(glVertex3fv)
RIGOR_DRAWS_NOTHING(glewInit)

#define GL_FALSE 0
#define GL_TRUE 1
#define GL_POINTS 0x0000
#define GL_LINES 0x0001
#define GL_LINE_LOOP 0x0002
#define GL_LINE_STRIP 0x0003
#define GL_TRIANGLES 0x0004
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRIANGLE_FAN 0x0006
#define GL_QUADS 0x0007
#define GL_POLYGON 0x0009
#define GL_FRONT 0x0404
#define GL_BACK 0x0405
#define GL_FRONT_AND_BACK 0x0408
#define GL_CULL_FACE 0x0B44
#define GL_LIGHTING 0x0B50
#define GL_COLOR_MATERIAL 0x0B57
#define GL_DEPTH_TEST 0x0B71
#define GL_NORMALIZE 0x0BA1
#define GL_BLEND 0x0BE2
#define GL_TEXTURE_2D 0x0DE1
#define GL_AMBIENT 0x1200
#define GL_DIFFUSE 0x1201
#define GL_SPECULAR 0x1202
#define GL_SHININESS 0x1601
#define GL_AMBIENT_AND_DIFFUSE 0x1602
#define GL_MODELVIEW 0x1700
#define GL_PROJECTION 0x1701
#define GL_LINE 0x1B01
#define GL_FILL 0x1B02
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#define GL_SRC_ALPHA 0x0302
#define GL_ONE_MINUS_SRC_ALPHA 0x0303
#define GL_COLOR_BUFFER_BIT 0x4000
#define GL_DEPTH_BUFFER_BIT 0x0100
