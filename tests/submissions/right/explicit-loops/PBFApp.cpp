// The window program: handed out, not ours, not compiled by a grader.
#include "PBFApp.h"
#include <GUILib/GLApplication.h>

int main() {
  PBFApp app;
  app.run();
}
