#pragma once
// Precompiled once and included before every file of a submission, for speed.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "GUILib/GLMesh.h"
#include "GUILib/GLUtils.h"
#include "GUILib/OBJReader.h"
#include "MathLib/P3D.h"
#include "MathLib/V3D.h"
#include "Utils/Logger.h"
