// rejected: include
// A definition that reads the bench's scene.
#pragma once
#include "tb/host/scene.hpp"
