// rejected: include
// A kernel that asks the bench for its mesh.
#pragma once
#include "tb/host/mesh.hpp"
