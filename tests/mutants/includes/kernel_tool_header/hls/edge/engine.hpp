// rejected: include
// A kernel that knows one tool's types.
#pragma once
#include <ap_fixed.h>
