// rejected: mirror
// A definition without a kernel.
#pragma once
