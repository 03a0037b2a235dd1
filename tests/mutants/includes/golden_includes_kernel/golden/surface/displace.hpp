// rejected: include
// A definition that copies the kernel's answer.
#pragma once
#include "hls/surface/displace.hpp"
