#include "CollisionPlane.h"
#define FILE "/etc/passwd"
#include FILE
#include "../../../../../../etc/hostname"
