#pragma once
// Visual Studio's precompiled header; here there is nothing in it.
